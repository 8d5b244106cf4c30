// Which shells can lie within which: only those whose boxes do.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/box_tree.h"

namespace sectile {

class ShellBoxes {
 public:
  /// One box per shell.
  explicit ShellBoxes(std::vector<Box> boxes);

  /// Does the box of any other shell hold that of this one?
  bool is_held(std::uint32_t shell) const { return is_held_[shell] != 0; }
  std::size_t held_count() const {
    return static_cast<std::size_t>(std::count(is_held_.begin(), is_held_.end(), 1));
  }
  /// Does the box of this shell hold that of any other one?
  bool holds_any(std::uint32_t shell) const { return holds_any_[shell] != 0; }
  /// All shells, those that reach farthest along the x axis first.
  std::vector<std::uint32_t> farthest_first() const;

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
