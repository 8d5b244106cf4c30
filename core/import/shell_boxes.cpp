#include "import/shell_boxes.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace sectile {

ShellBoxes::ShellBoxes(std::vector<Box> boxes)
    : boxes_(std::move(boxes)), is_held_(boxes_.size(), 0), holds_any_(boxes_.size(), 0) {
  find_held();
  find_holding();
}

void ShellBoxes::find_held() {
  const BoxTree tree(boxes_);
  for (std::uint32_t s = 0; s < boxes_.size(); ++s)
    tree.query([&](const Box& b) { return is_held_[s] == 0 && contains(b, boxes_[s]); },
               [&](std::uint32_t t) { is_held_[s] |= t != s ? 1 : 0; });
}

// The tree of those that are not known to hold any is made anew as soon as known ones were met in
// it as often as it has members: so nests of many shells take no longer than others.
void ShellBoxes::find_holding() {
  std::vector<std::uint32_t> unknown(boxes_.size());
  std::iota(unknown.begin(), unknown.end(), 0u);
  BoxTree tree(boxes_);
  std::size_t met = 0;
  for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
    if (is_held_[s] == 0) continue;
    tree.query([&](const Box& b) { return contains(b, boxes_[s]); },
               [&](std::uint32_t i) {
                 met += holds_any_[unknown[i]];
                 if (unknown[i] != s) holds_any_[unknown[i]] = 1;
               });
    if (met <= unknown.size()) continue;
    std::erase_if(unknown, [&](std::uint32_t t) { return holds_any_[t] != 0; });
    std::vector<Box> left;
    for (const std::uint32_t t : unknown) left.push_back(boxes_[t]);
    tree = BoxTree(left);
    met = 0;
  }
}

std::vector<std::uint32_t> ShellBoxes::farthest_first() const {
  std::vector<std::uint32_t> order(boxes_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
    return boxes_[s].high[0] > boxes_[t].high[0];
  });
  return order;
}

}  // namespace sectile
