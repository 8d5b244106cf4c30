#include "scene/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace sectile::viewer {

namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<FloatBox>& items) : order_(items.size()) {
  if (items.empty()) return;
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(items.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(items.size()), items);
  box_ = nodes_.front().box;
}

void BoxTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last,
                    const std::vector<FloatBox>& items) {
  FloatBox box, centres;
  for (std::uint32_t i = first; i < last; ++i) {
    box.add(items[order_[i]]);
    centres.add(items[order_[i]].low + items[order_[i]].high);
  }
  nodes_[node].box = box;
  if (last - first <= leaf_size) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  const glm::vec3 extent = centres.high - centres.low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t middle = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return items[a].low[axis] + items[a].high[axis] <
                            items[b].low[axis] + items[b].high[axis];
                   });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.emplace_back();
  nodes_[node].first = child;
  build(child, first, middle, items);
  build(child + 1, middle, last, items);
}

double BoxTree::entry(const FloatBox& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                      double margin) {
  double from = 0, to = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    double near = (box.low[i] - margin - origin[i]) * inverse[i];
    double far = (box.high[i] + margin - origin[i]) * inverse[i];
    if (near > far) std::swap(near, far);
    // A line within a side of the box gives NaN, which changes nothing here.
    if (near > from) from = near;
    if (far < to) to = far;
  }
  return from <= to ? from : std::numeric_limits<double>::infinity();
}

}  // namespace sectile::viewer
