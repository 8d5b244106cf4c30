#include "search/box_index.h"

#include "search/curve_order.h"

namespace sectile {

BoxIndex::Four::Four() {
  const Box none;
  for (std::size_t i = 0; i < 4; ++i) set(i, none);
}

void BoxIndex::Four::set(std::size_t i, const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k][i] = box.low[k];
    high[k][i] = box.high[k];
  }
}

Box BoxIndex::Four::around() const {
  Box box;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 4; ++i) {
      box.low[k] = std::min(box.low[k], low[k][i]);
      box.high[k] = std::max(box.high[k], high[k][i]);
    }
  return box;
}

BoxIndex::BoxIndex(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.add(box);
  items_ = numbers_of(
      keys_along_curve(boxes.size(), all, [&](std::size_t i) -> const Box& { return boxes[i]; }));
  std::vector<Four>& lowest = levels_.emplace_back((boxes.size() + 3) / 4);
  for (std::size_t i = 0; i < items_.size(); ++i) lowest[i / 4].set(i % 4, boxes[items_[i]]);
  while (levels_.back().size() > 1) {
    std::vector<Four> level((levels_.back().size() + 3) / 4);
    for (std::size_t i = 0; i < levels_.back().size(); ++i)
      level[i / 4].set(i % 4, levels_.back()[i].around());
    levels_.push_back(std::move(level));
  }
}

}  // namespace sectile
