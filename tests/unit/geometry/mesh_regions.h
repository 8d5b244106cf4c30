// Random faces with everything that is legal, cut out of a mesh of small triangles.
#pragma once

#include <cstdint>
#include <random>

#include "unit/geometry/grid_predicates.h"

namespace sectile::test {

/// How loops that touch in a place are traced: corners enclose only region, or as little of it as
/// possible, or the one at some places and the other at others.
enum class Tracing { region, outside, mixed };

struct MeshRegionOptions {
  int width = 6, height = 6;
  double filled = 0.6;        ///< how many of the small triangles may belong to the region, about
  double slits = 0.1;         ///< how many of the edges within it become slits, about
  double straightened = 0.5;  ///< how many of the corners of 180° are left out, about
  Tracing tracing = Tracing::region;
  bool sheared = true;
};

/// One connected region: the outer loop counter-clockwise, inner loops clockwise, in any order.
Region random_mesh_region(const MeshRegionOptions& options, std::mt19937& random);

}  // namespace sectile::test
