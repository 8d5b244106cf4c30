// Polygons with holes as triangles: the triangulation that meshes are made with.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

/// Three corners of a polygon, by their numbers.
using CornerTriangle = std::array<std::uint32_t, 3>;

/// Triangles of one polygon, counter-clockwise seen from where the polygon is. Its corners are
/// numbered through, loop after loop: loop k has the corners loop_ends[k - 1] to loop_ends[k] - 1,
/// counter-clockwise around the polygon, clockwise around its holes. Loops may touch themselves
/// and each other.
///
/// The polygon is seen along the axis on which it shows the largest area, and what is decided
/// there is decided exactly. So it need not be flat, as it never is once its corners were rounded.
/// Every edge of a loop is then an edge of one triangle more in its direction than against it;
/// some triangles may have no area. A single loop whose edges cross each other from all sides
/// becomes a fan.
///
/// Takes O(n log n). Throws std::invalid_argument for loops without corners and coordinates that
/// are not finite, and InvalidSolid (self_intersecting) for holes whose edges cross others.
std::vector<CornerTriangle> triangulate(std::span<const Vec3> corners,
                                        std::span<const std::uint32_t> loop_ends);

}  // namespace sectile
