// Do edges of a plane face cross each other?
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// Do two edges of the loops cross in a point within both, as seen along an axis? The corners of
/// all loops are explicit and stand one after another; loop k ends before corner loop_ends[k].
/// `behind`: the normal points along the axis' other side.
bool edges_cross(const Kernel& kernel, int axis, bool behind, std::span<const PointId> corners,
                 std::span<const std::uint32_t> loop_ends);

}  // namespace sectile
