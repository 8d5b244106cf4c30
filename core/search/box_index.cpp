#include "search/box_index.h"

#include "search/curve_order.h"

namespace sectile {

BoxIndex::BoxIndex(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.add(box);
  items_ = numbers_of(
      keys_along_curve(boxes.size(), all, [&](std::size_t i) -> const Box& { return boxes[i]; }));
  std::vector<FourBoxes>& lowest = levels_.emplace_back((boxes.size() + 3) / 4);
  for (std::size_t i = 0; i < items_.size(); ++i) lowest[i / 4].set(i % 4u, boxes[items_[i]]);
  while (levels_.back().size() > 1) {
    std::vector<FourBoxes> level((levels_.back().size() + 3) / 4);
    for (std::size_t i = 0; i < levels_.back().size(); ++i)
      level[i / 4].set(i % 4u, levels_.back()[i].all());
    levels_.push_back(std::move(level));
  }
}

}  // namespace sectile
