#include "sectile/box_search.h"

#include <limits>
#include <utility>
#include <vector>

#include "search/box_tree.h"

namespace sectile {
namespace {

Box rounded_outwards(const Extent& extent) {
  return Bounds{extent.low, extent.high}.box();
}

/// A line in one direction.
class Line {
 public:
  Line(const Vec3& origin, const Vec3& direction, double margin)
      : origin_{origin.x, origin.y, origin.z},
        inverse_{1 / direction.x, 1 / direction.y, 1 / direction.z},
        margin_(margin) {}

  /// Where it enters a box with the margin around; infinite if it misses it.
  double entry(const Box& box) const {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      double near = (static_cast<double>(box.low[k]) - margin_ - origin_[k]) * inverse_[k];
      double far = (static_cast<double>(box.high[k]) + margin_ - origin_[k]) * inverse_[k];
      if (near > far) std::swap(near, far);
      // A line within a side of the box gives NaN, which changes nothing here.
      if (near > from) from = near;
      if (far < to) to = far;
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  }

 private:
  double origin_[3], inverse_[3], margin_;
};

}  // namespace

BoxSearch::BoxSearch(std::span<const Extent> things) {
  if (things.empty()) return;
  std::vector<Box> boxes;
  boxes.reserve(things.size());
  for (const Extent& thing : things) boxes.push_back(rounded_outwards(thing));
  tree_ = std::make_shared<const BoxTree>(boxes);
}

Extent BoxSearch::extent() const {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!tree_) return {{none, none, none}, {-none, -none, -none}};
  const Box& box = tree_->bounds();
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

void BoxSearch::visit_near(const Extent& place, Visitor visit) const {
  if (!tree_) return;
  const Box box = rounded_outwards(place);
  tree_->query([&](const Box& other) { return box.overlaps(other); }, visit);
}

void BoxSearch::visit_along(const Vec3& origin, const Vec3& direction, double margin,
                            const double& limit, Visitor visit) const {
  if (!tree_) return;
  const Line line(origin, direction, margin);
  struct Waiting {
    BoxTree::Node node;
    double entry;
  };
  // Below each node all children but one wait while that is looked into.
  constexpr std::size_t most_levels = 16;
  Waiting stack[most_levels * (BoxTree::width - 1) + 1];
  std::size_t top = 0;
  const BoxTree::Node root = tree_->root();
  stack[top++] = {root, line.entry(tree_->box(root))};
  while (top > 0) {
    const auto [node, entry] = stack[--top];
    // Not before: what was visited meanwhile may have lowered the limit.
    if (entry > limit || entry == std::numeric_limits<double>::infinity()) continue;
    if (node.level == 0) {
      for (const std::uint32_t thing : tree_->items(node)) visit(thing);
      continue;
    }
    const std::size_t first = top;
    for (std::uint32_t i = 0; i < tree_->child_count(node); ++i) {
      const BoxTree::Node child = BoxTree::child(node, i);
      Waiting next{child, line.entry(tree_->box(child))};
      std::size_t at = top++;  // the nearest one last
      for (; at > first && stack[at - 1].entry < next.entry; --at) stack[at] = stack[at - 1];
      stack[at] = next;
    }
  }
}

}  // namespace sectile
