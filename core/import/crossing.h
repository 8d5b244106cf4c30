// Do edges of a plane face cross each other?
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "import/polygons.h"

namespace sectile {

/// Do two edges of the loops cross in a point within both, as seen along an axis? The corners of
/// all loops are explicit and stand one after another; loop k ends before corner loop_ends[k].
/// `behind`: the normal points along the axis' other side. Where crossing faces are to be split,
/// also: does a loop pass an edge, or run along it, in a corner that lies within the edge? (Where
/// they are refused, that is found when all faces are tested, as it may be legal.)
bool edges_cross(const Kernel& kernel, int axis, bool behind, std::span<const PointId> corners,
                 std::span<const std::uint32_t> loop_ends, CrossingFaces how);

}  // namespace sectile
