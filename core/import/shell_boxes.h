// Which shells can lie within which: only those whose boxes do.
#pragma once

#include <cstdint>
#include <vector>

#include "search/box_tree.h"

namespace sectile {

class ShellBoxes {
 public:
  /// One box per shell.
  explicit ShellBoxes(std::vector<Box> boxes);

  /// Does the box of a shell hold that of another one, or is it the same one?
  bool holds(std::uint32_t outer, std::uint32_t inner) const {
    return contains(boxes_[outer], boxes_[inner]);
  }
  /// Does the box of any other shell hold that of this one?
  bool is_held(std::uint32_t shell) const { return is_held_[shell] != 0; }
  /// Does the box of this shell hold that of any other one?
  bool holds_any(std::uint32_t shell) const { return holds_any_[shell] != 0; }
  /// All shells; each comes after those whose boxes hold its own, except for equal ones.
  std::vector<std::uint32_t> from_outside() const;

 private:
  static bool contains(const Box& outer, const Box& inner) {
    for (int k = 0; k < 3; ++k)
      if (!(outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k])) return false;
    return true;
  }
  void find_held();
  void find_holding();

  std::vector<Box> boxes_;
  std::vector<std::uint8_t> is_held_, holds_any_;
};

}  // namespace sectile
