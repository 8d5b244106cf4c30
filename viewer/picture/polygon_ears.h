// Triangles of a polygon with holes, for drawing: corners are rounded, so nothing is exact here and
// nothing depends on it. Export and the Booleans use the exact triangulation of core.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sectile::viewer {

/// The outer loop first, counter-clockwise; holes clockwise. Indices into `places`.
using Loops = std::vector<std::vector<std::uint32_t>>;

/// Cuts off ears. Always ends: where rounding left no clean ear, the best corner is taken.
std::vector<std::array<std::uint32_t, 3>> ears(const std::vector<glm::dvec2>& places,
                                               const Loops& loops);

}  // namespace sectile::viewer
