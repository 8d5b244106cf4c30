// Equal positions are one point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/geometry.h"

namespace sectile {

/// Per position the first one that is equal to it; nothing if all are different. -0 and 0 are one
/// coordinate.
std::vector<std::uint32_t> first_equals(std::span<const Vec3> positions);

/// Adds the points of the positions to an empty geometry, in the order in which they are first met,
/// and gives that of each. `input_vertex` becomes each point's first position.
std::vector<PointId> unite_positions(std::span<const Vec3> positions, Geometry& geometry,
                                     std::vector<std::uint32_t>& input_vertex);

}  // namespace sectile
