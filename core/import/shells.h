// Shells: the connected parts of a boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "storage/solid_data.h"

namespace sectile {

struct Shells {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

/// Faces are connected over edges.
Shells find_shells(const Brep& brep);

/// Per shell: the sign of the volume that its faces enclose. All points must be explicit.
std::vector<Sign> signs_of_volumes(const Brep& brep, const Geometry& geometry,
                                   const Shells& shells);

/// Refuses shells that are not nested as those of a solid are: from outside, the first is turned
/// outwards, those within it inwards, and so on. All points must be explicit.
void check_orientation(const SolidData& data, const Kernel& kernel);

}  // namespace sectile
