// Shells: the connected parts of a boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "topology/brep.h"

namespace sectile {

struct Shells {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

/// Faces are connected over edges.
Shells find_shells(const Brep& brep);

/// Refuses a solid whose material would be infinite: each shell that is turned inwards must have
/// another one around it. All points must be explicit.
void check_orientation(const Brep& brep, const Geometry& geometry);

}  // namespace sectile
