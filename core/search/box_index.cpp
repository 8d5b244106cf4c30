#include "search/box_index.h"

#include <numeric>

#include "search/curve_order.h"

namespace sectile {

BoxIndex::BoxIndex(const std::vector<Box>& boxes, bool along_curve) {
  if (boxes.empty()) return;
  items_.resize(boxes.size());
  if (along_curve)
    std::iota(items_.begin(), items_.end(), 0u);
  else
    items_ = order_along_curve(boxes);
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
