// Vertices of a mesh around which all is clear: see clear_star.h.
#pragma once

#include <cstdint>
#include <vector>

#include "rounding/rounded_triangles.h"

namespace sectile {

/// Per vertex of a mesh in which nothing was changed yet: 1 if no two triangles at it meet in
/// anything but common corners, or did on the way on which rounding moved them. Zero also if more
/// than doubles is needed to tell, and at vertices of none of the triangles in `of`. `slack`: no
/// coordinate was farther away.
std::vector<std::uint8_t> clear_stars(const RoundedTriangles& mesh,
                                      const RoundedTriangles::Triangles& of, double slack);

}  // namespace sectile
