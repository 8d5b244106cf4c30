// A bounding volume hierarchy over boxes: leaves in the order of a curve, levels of pairs above
// them.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "search/four_boxes.h"

namespace sectile {

class BoxTree {
 public:
  static constexpr std::uint32_t leaf_size = 4;

  BoxTree() = default;
  /// Takes the boxes of items 0 … boxes.size() - 1. If not empty, `group` puts each item into a
  /// group (or none), and groups stay together. Items that are `along_curve` stay in the order in
  /// which they are.
  explicit BoxTree(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& group = {},
                   bool along_curve = false);
  static constexpr std::uint32_t no_group = 0xFFFFFFFFu;

  bool empty() const { return items_.empty(); }
  const Box& bounds() const { return levels_.back().front(); }

  /// Calls visit(item) for every item whose box satisfies meets(box); meets must hold for any box
  /// that contains a box for which it holds.
  template <class Meets, class Visit>
  void query(const Meets& meets, Visit&& visit) const {
    query(meets, visit, [](std::uint32_t) { return false; });
  }
  /// The same without the items whose group satisfies skip(group).
  template <class Meets, class Visit, class Skip>
  void query(const Meets& meets, Visit&& visit, const Skip& skip) const {
    if (!empty()) query(root(), meets, visit, skip);
  }

  /// The same, where meets(node) tells it of all that is under a node, too. Of two parts that one
  /// is visited first for which before(node, other) holds.
  template <class Meets, class Before, class Visit>
  void query_in_order(const Meets& meets, const Before& before, Visit&& visit) const {
    if (!empty()) query_in_order(root(), meets, before, visit);
  }

  /// Calls visit(item of a, item of b) for every pair of overlapping boxes.
  template <class Visit>
  static void overlaps(const BoxTree& a, const BoxTree& b, Visit&& visit) {
    overlaps(a, b, visit, [](std::uint32_t, std::uint32_t) { return false; });
  }
  /// The same without the pairs of items whose groups satisfy skip(group of a, group of b).
  template <class Visit, class Skip>
  static void overlaps(const BoxTree& a, const BoxTree& b, Visit&& visit, const Skip& skip) {
    overlaps(a, b, visit, skip, NothingApart());
  }

  /// A leaf (on level 0) or what is above leaves.
  struct Node {
    std::uint32_t level, index;
  };
  /// What more is known to be apart than boxes say: two nodes, an item of a and all in a smaller
  /// box of b, and the other way around.
  struct NothingApart {
    bool nodes(Node, Node) const { return false; }
    bool item_of_a(std::uint32_t, const Box&) const { return false; }
    bool item_of_b(std::uint32_t, const Box&) const { return false; }
  };
  /// The same without what `apart` knows to be apart.
  template <class Visit, class Skip, class Apart>
  static void overlaps(const BoxTree& a, const BoxTree& b, Visit&& visit, const Skip& skip,
                       const Apart& apart) {
    if (a.empty() || b.empty()) return;
    overlaps(a, a.root(), b, b.root(), visit, skip, apart);
  }

  std::uint32_t level_count() const { return static_cast<std::uint32_t>(levels_.size()); }
  std::size_t node_count(std::uint32_t level) const { return levels_[level].size(); }
  const Box& box(Node n) const { return levels_[n.level][n.index]; }
  /// The items under a node.
  std::span<const std::uint32_t> items(Node n) const {
    const std::size_t width = std::size_t(leaf_size) << n.level, from = n.index * width;
    return std::span(items_).subspan(from, std::min(width, items_.size() - from));
  }

  /// A part of all pairs of a tree's own items: those of two nodes, or of one node.
  class SelfPart {
    friend class BoxTree;
    SelfPart(Node first, Node second) : p(first), q(second) {}
    Node p, q;
  };
  /// Divides the pairs into parts that can be visited side by side: `least` of them, if there are
  /// as many nodes.
  std::vector<SelfPart> self_parts(std::size_t least) const;
  /// Calls visit(item, other item) once for every pair of overlapping boxes in a part, but not for
  /// two of one group.
  template <class Visit>
  void self_overlaps(const SelfPart& part, Visit&& visit) const {
    self_overlaps(part, visit, NothingApart());
  }
  /// The same without what `apart` knows to be apart.
  template <class Visit, class Apart>
  void self_overlaps(const SelfPart& part, Visit&& visit, const Apart& apart) const;

 private:
  Node root() const { return {static_cast<std::uint32_t>(levels_.size() - 1), 0}; }
  bool has_second_child(Node n) const {
    return 2 * std::size_t(n.index) + 1 < levels_[n.level - 1].size();
  }
  static Node child(Node n, std::uint32_t which) { return {n.level - 1, 2 * n.index + which}; }
  std::pair<std::uint32_t, std::uint32_t> range(std::uint32_t leaf) const {
    const auto count = static_cast<std::uint32_t>(items_.size());
    return {leaf * leaf_size, std::min(count, (leaf + 1) * leaf_size)};
  }

  template <class Visit, class Skip, class Apart>
  static void overlaps(const BoxTree& a, Node p, const BoxTree& b, Node q, Visit& visit,
                       const Skip& skip, const Apart& apart);
  template <class Skip>
  static bool skips(const BoxTree& a, Node p, const BoxTree& b, Node q, const Skip& skip) {
    if (a.group_levels_.empty() || b.group_levels_.empty()) return false;
    const std::uint32_t g = a.group_levels_[p.level][p.index],
                        h = b.group_levels_[q.level][q.index];
    return g != no_group && h != no_group && skip(g, h);
  }
  static_assert(leaf_size == 4);  // as many as FourBoxes
  template <class IsApart>
  unsigned near_items(std::uint32_t leaf, const Box& box, const IsApart& is_apart) const;
  /// Calls visit(i), ascending, for all bits i that are set.
  template <class Visit>
  static void for_each_bit(unsigned bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<unsigned>(std::countr_zero(bits)));
  }
  void build_groups(const std::vector<std::uint32_t>& group);
  bool are_of_one_group(std::uint32_t i, std::uint32_t j) const {
    return !item_groups_.empty() && item_groups_[i] != no_group &&
           item_groups_[i] == item_groups_[j];
  }

  template <class Meets, class Visit, class Skip>
  void query(Node n, const Meets& meets, Visit& visit, const Skip& skip) const {
    if (!meets(box(n))) return;
    const auto is_skipped = [&](std::uint32_t group) { return group != no_group && skip(group); };
    if (!group_levels_.empty() && is_skipped(group_levels_[n.level][n.index])) return;
    if (n.level > 0) {
      query(child(n, 0), meets, visit, skip);
      if (has_second_child(n)) query(child(n, 1), meets, visit, skip);
      return;
    }
    visit_leaf(n, meets, [&](std::uint32_t i) {
      if (item_groups_.empty() || !is_skipped(item_groups_[i])) visit(items_[i]);
    });
  }
  template <class Meets, class Before, class Visit>
  void query_in_order(Node n, const Meets& meets, const Before& before, Visit& visit) const {
    if (!meets(n)) return;
    if (n.level == 0) return visit_leaf(n, meets, [&](std::uint32_t i) { visit(items_[i]); });
    Node first = child(n, 0), second = child(n, 1);
    if (!has_second_child(n)) return query_in_order(first, meets, before, visit);
    if (before(second, first)) std::swap(first, second);
    query_in_order(first, meets, before, visit);
    query_in_order(second, meets, before, visit);
  }
  template <class Meets, class Visit>
  void visit_leaf(Node leaf, const Meets& meets, const Visit& visit) const {
    const auto [from, to] = range(leaf.index);
    for (std::uint32_t i = from; i < to; ++i)
      if (meets(leaf_boxes_[leaf.index].get(i - from))) visit(i);
  }

  std::vector<std::uint32_t> items_;      // in the order of a curve
  std::vector<FourBoxes> leaf_boxes_;     // those of the items of each leaf
  std::vector<std::vector<Box>> levels_;  // leaves first, the root last
  // The common group of all items of a node, or no_group. Empty if there are no groups.
  std::vector<std::uint32_t> item_groups_;
  std::vector<std::vector<std::uint32_t>> group_levels_;
};

template <class Visit, class Apart>
void BoxTree::self_overlaps(const SelfPart& part, Visit&& visit, const Apart& apart) const {
  const auto [p, q] = std::pair(part.p, part.q);
  if (p.level != q.level || p.index != q.index) {
    overlaps(
        *this, p, *this, q, visit, [](std::uint32_t g, std::uint32_t h) { return g == h; }, apart);
    return;
  }
  if (!group_levels_.empty() && group_levels_[p.level][p.index] != no_group) return;
  if (p.level > 0) {
    const Node first = child(p, 0);
    self_overlaps(SelfPart(first, first), visit, apart);
    if (!has_second_child(p)) return;
    const Node second = child(p, 1);
    self_overlaps(SelfPart(second, second), visit, apart);
    self_overlaps(SelfPart(first, second), visit, apart);
    return;
  }
  const auto [from, to] = range(p.index);
  const FourBoxes& boxes = leaf_boxes_[p.index];
  for (std::uint32_t i = from; i + 1 < to; ++i) {
    const unsigned later = 0xEu << (i - from);
    for_each_bit(boxes.overlapping(boxes.get(i - from)) & later, [&, first = from](unsigned l) {
      if (!are_of_one_group(i, first + l)) visit(items_[i], items_[first + l]);
    });
  }
}

template <class Visit, class Skip, class Apart>
void BoxTree::overlaps(const BoxTree& a, Node p, const BoxTree& b, Node q, Visit& visit,
                       const Skip& skip, const Apart& apart) {
  if (!a.box(p).overlaps(b.box(q)) || skips(a, p, b, q, skip) || apart.nodes(p, q)) return;
  if (p.level == 0 || q.level == 0) {
    const auto of_a = [&](std::uint32_t item) { return apart.item_of_a(item, b.box(q)); };
    const auto of_b = [&](std::uint32_t item) { return apart.item_of_b(item, a.box(p)); };
    const unsigned near_a = p.level == 0 ? a.near_items(p.index, b.box(q), of_a) : 1;
    if (near_a == 0) return;
    const unsigned near_b = q.level == 0 ? b.near_items(q.index, a.box(p), of_b) : 1;
    if (near_b == 0) return;
    if (p.level == 0 && q.level == 0) {
      const bool grouped = !a.item_groups_.empty() && !b.item_groups_.empty();
      const FourBoxes &boxes_of_a = a.leaf_boxes_[p.index], &boxes_of_b = b.leaf_boxes_[q.index];
      for_each_bit(near_a, [&](unsigned k) {
        const std::uint32_t i = p.index * leaf_size + k;
        for_each_bit(near_b & boxes_of_b.overlapping(boxes_of_a.get(k)), [&](unsigned l) {
          const std::uint32_t j = q.index * leaf_size + l;
          if (grouped && a.item_groups_[i] != no_group && b.item_groups_[j] != no_group &&
              skip(a.item_groups_[i], b.item_groups_[j]))
            return;
          visit(a.items_[i], b.items_[j]);
        });
      });
      return;
    }
  }
  // The larger one first, so that large items meet nodes that are small beside them.
  if (p.level > 0 && (q.level == 0 || !b.box(q).is_larger_than(a.box(p)))) {
    overlaps(a, child(p, 0), b, q, visit, skip, apart);
    if (a.has_second_child(p)) overlaps(a, child(p, 1), b, q, visit, skip, apart);
  } else {
    overlaps(a, p, b, child(q, 0), visit, skip, apart);
    if (b.has_second_child(q)) overlaps(a, p, b, child(q, 1), visit, skip, apart);
  }
}

// Bits: those of a leaf that may meet what is in a box, as far as boxes tell, and, if they are
// larger, is_apart(item).
template <class IsApart>
unsigned BoxTree::near_items(std::uint32_t leaf, const Box& box, const IsApart& is_apart) const {
  unsigned near = leaf_boxes_[leaf].overlapping(box);
  for_each_bit(near, [&](unsigned i) {
    if (leaf_boxes_[leaf].get(i).is_larger_than(box) && is_apart(items_[leaf * leaf_size + i]))
      near &= ~(1u << i);
  });
  return near;
}

}  // namespace sectile
