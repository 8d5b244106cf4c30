// Shells of long thin slanted triangles: their boxes overlap far and wide, they themselves hardly.
#pragma once

#include <cstdint>

#include "sectile/mesh.h"

namespace sectile::bench {

/// A pipe around the z axis from z = -1 to 1 whose upper end is turned against the lower one: its
/// two walls have 4 · needles triangles, each of which reaches from end to end. Throws
/// std::invalid_argument if the wall is too thin for so few needles.
struct TwistedPipe {
  std::uint32_t needles = 1000;
  double inner_radius = 0.9, outer_radius = 1;
  double twist = 2;  ///< radians, at most 2.5 either way
};
PolygonMesh twisted_pipe(const TwistedPipe& pipe);

}  // namespace sectile::bench
