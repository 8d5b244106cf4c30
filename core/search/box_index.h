// Which of many boxes overlap one: a hierarchy of four boxes each, which are tested at one go.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "search/four_boxes.h"

namespace sectile {

/// For single boxes that come one after another; pairs of two sets are the business of BoxTree.
class BoxIndex {
 public:
  BoxIndex() = default;
  /// Items are 0 … boxes.size() - 1. Those that are `along_curve` stay in the order in which they
  /// are.
  explicit BoxIndex(const std::vector<Box>& boxes, bool along_curve = false);

  /// Calls visit(item) for all whose boxes overlap this one, until it returns false. Did it never?
  template <class Visit>
  bool overlapping(const Box& box, const Visit& visit) const {
    return overlapping(box, static_cast<std::uint32_t>(items_.size()), visit);
  }
  /// The same of the first items, in their order along the curve.
  template <class Visit>
  bool overlapping(const Box& box, std::uint32_t first, const Visit& visit) const {
    return overlapping(box, first, visit, [](std::uint64_t, std::uint32_t) { return false; });
  }
  /// The same without what is known to be apart otherwise: all items from 4^level · index on, up to
  /// 4^level of them, in their order along the curve.
  template <class Visit, class IsApart>
  bool overlapping(const Box& box, std::uint32_t first, const Visit& visit,
                   const IsApart& is_apart) const;

  bool any_overlaps(const Box& box) const {
    return !overlapping(box, [](std::uint32_t) { return false; });
  }

 private:
  // Level and index in one number, as it is put away and taken back all the time.
  static std::uint64_t node(std::uint64_t level, std::uint32_t index) {
    return level << 32 | index;
  }

  std::vector<std::uint32_t> items_;            // along a curve
  std::vector<std::vector<FourBoxes>> levels_;  // of the items first, of a single one last
};

template <class Visit, class IsApart>
bool BoxIndex::overlapping(const Box& box, std::uint32_t first, const Visit& visit,
                           const IsApart& is_apart) const {
  if (first == 0) return true;
  std::array<std::uint64_t, 64> open;  // three nodes of each of sixteen levels at most
  std::size_t count = 0;
  open[count++] = node(levels_.size() - 1, 0);
  while (count > 0) {
    const std::uint64_t next = open[--count], level = next >> 32;
    const auto index = static_cast<std::uint32_t>(next);
    for (unsigned hit = levels_[level][index].overlapping(box); hit != 0; hit &= hit - 1) {
      const std::uint32_t below = 4 * index + static_cast<std::uint32_t>(std::countr_zero(hit));
      if (std::uint64_t(below) << (2 * level) >= first) break;  // as are those after it
      if (is_apart(level, below)) continue;
      if (level > 0)
        open[count++] = node(level - 1, below);
      else if (!visit(items_[below]))
        return false;
    }
  }
  return true;
}

}  // namespace sectile
