// A bounding volume hierarchy over boxes: leaves in Morton order, levels of pairs above them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "search/box.h"

namespace sectile {

class BoxTree {
 public:
  static constexpr std::uint32_t leaf_size = 4;

  BoxTree() = default;
  /// Takes the boxes of items 0 … boxes.size() - 1.
  explicit BoxTree(const std::vector<Box>& boxes);

  bool empty() const { return items_.empty(); }
  const Box& bounds() const { return levels_.back().front(); }

  /// Calls visit(item) for every item whose box satisfies meets(box); meets must hold for any box
  /// that contains a box for which it holds.
  template <class Meets, class Visit>
  void query(const Meets& meets, Visit&& visit) const {
    if (!empty()) query(root(), meets, visit);
  }

  /// Calls visit(item of a, item of b) for every pair of overlapping boxes.
  template <class Visit>
  static void overlaps(const BoxTree& a, const BoxTree& b, Visit&& visit) {
    if (a.empty() || b.empty() || !a.bounds().overlaps(b.bounds())) return;
    overlaps(a, a.root(), b, b.root(), visit);
  }

  struct Node {
    std::uint32_t level, index;
  };
  using NodePair = std::pair<Node, Node>;
  /// Cuts the traversal into about `wanted` independent pairs of nodes that overlap, in order.
  static std::vector<NodePair> overlapping_nodes(const BoxTree& a, const BoxTree& b,
                                                 std::size_t wanted);
  template <class Visit>
  static void overlaps(const BoxTree& a, Node p, const BoxTree& b, Node q, Visit& visit);

 private:
  Node root() const { return {static_cast<std::uint32_t>(levels_.size() - 1), 0}; }
  const Box& box(Node n) const { return levels_[n.level][n.index]; }
  bool has_second_child(Node n) const {
    return 2 * std::size_t(n.index) + 1 < levels_[n.level - 1].size();
  }
  static Node child(Node n, std::uint32_t which) { return {n.level - 1, 2 * n.index + which}; }
  std::pair<std::uint32_t, std::uint32_t> range(std::uint32_t leaf) const {
    const auto count = static_cast<std::uint32_t>(items_.size());
    return {leaf * leaf_size, std::min(count, (leaf + 1) * leaf_size)};
  }

  template <class Meets, class Visit>
  void query(Node n, const Meets& meets, Visit& visit) const {
    if (!meets(box(n))) return;
    if (n.level > 0) {
      query(child(n, 0), meets, visit);
      if (has_second_child(n)) query(child(n, 1), meets, visit);
      return;
    }
    const auto [from, to] = range(n.index);
    for (std::uint32_t i = from; i < to; ++i)
      if (meets(item_boxes_[i])) visit(items_[i]);
  }

  std::vector<std::uint32_t> items_;      // in Morton order
  std::vector<Box> item_boxes_;           // in the same order
  std::vector<std::vector<Box>> levels_;  // leaves first, the root last
};

template <class Visit>
void BoxTree::overlaps(const BoxTree& a, Node p, const BoxTree& b, Node q, Visit& visit) {
  if (!a.box(p).overlaps(b.box(q))) return;
  if (p.level == 0 && q.level == 0) {
    const auto [from_a, to_a] = a.range(p.index);
    const auto [from_b, to_b] = b.range(q.index);
    for (std::uint32_t i = from_a; i < to_a; ++i)
      for (std::uint32_t j = from_b; j < to_b; ++j)
        if (a.item_boxes_[i].overlaps(b.item_boxes_[j])) visit(a.items_[i], b.items_[j]);
    return;
  }
  if (p.level >= q.level) {
    overlaps(a, child(p, 0), b, q, visit);
    if (a.has_second_child(p)) overlaps(a, child(p, 1), b, q, visit);
  } else {
    overlaps(a, p, b, child(q, 0), visit);
    if (b.has_second_child(q)) overlaps(a, p, b, child(q, 1), visit);
  }
}

}  // namespace sectile
