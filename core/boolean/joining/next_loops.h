// Which loops of a plane lie next to each other: a line sweeps over all of them, so that however
// many lie in bends of others, n log n tests tell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// Loops that do not cross and have regions of a plane on their left, as the parts of a face do.
class NextLoops {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /// Loop k has the corners loop_ends[k - 1] to loop_ends[k] - 1. The first so many of them are
  /// holes, and are asked for.
  NextLoops(const Kernel& kernel, PlaneId plane, std::span<const PointId> corners,
            std::span<const std::uint32_t> loop_ends, std::uint32_t holes);

  /// Another loop around the region that a hole is cut out of, which goes farther along an axis.
  /// None where there is nothing more on that side, and where others touch the hole at its end.
  std::uint32_t operator[](std::uint32_t hole) const { return next_[hole]; }

 private:
  std::vector<std::uint32_t> next_;  // per hole
};

}  // namespace sectile
