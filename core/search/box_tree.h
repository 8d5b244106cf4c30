// A bounding volume hierarchy over boxes: leaves in the order of a curve, levels of fours above
// them. What is under a node is compared with a box at one go.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "search/four_boxes.h"

namespace sectile {

class BoxTree {
 public:
  static constexpr std::uint32_t width = 4;  // items of a leaf, nodes below another one

  BoxTree() = default;
  /// Takes the boxes of items 0 … boxes.size() - 1. If not empty, `group` puts each item into a
  /// group (or none), and groups stay together. Items that are `along_curve` stay in the order in
  /// which they are if there are no groups.
  explicit BoxTree(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& group = {},
                   bool along_curve = false);
  static constexpr std::uint32_t no_group = 0xFFFFFFFFu;

  bool empty() const { return items_.empty(); }
  const Box& bounds() const { return bounds_; }

  /// A leaf (on level 0) or what is above leaves.
  struct Node {
    std::uint32_t level, index;
  };
  /// Of a tree that is not empty.
  Node root() const { return {level_count() - 1, 0}; }
  std::uint32_t level_count() const {
    return empty() ? 0 : static_cast<std::uint32_t>(first_.size()) - 1;
  }
  std::uint32_t node_count(std::uint32_t level) const { return first_[level + 1] - first_[level]; }
  Box box(Node n) const {
    if (n.level + 1 == level_count()) return bounds_;
    return below({n.level + 1, n.index / width}).get(n.index % width);
  }
  /// Of a node that is no leaf.
  std::uint32_t child_count(Node n) const {
    return std::min(width, node_count(n.level - 1) - n.index * width);
  }
  static Node child(Node n, std::uint32_t which) { return {n.level - 1, n.index * width + which}; }
  /// Of a node, or an item of a leaf, below a node.
  Box box_below(Node n, std::uint32_t which) const { return below(n).get(which); }
  /// The items under a node.
  std::span<const std::uint32_t> items(Node n) const {
    const std::size_t under = std::size_t(width) << 2 * n.level, from = n.index * under;
    return std::span(items_).subspan(from, std::min(under, items_.size() - from));
  }

  /// Calls visit(item) for every item whose box satisfies meets(box); meets must hold for any box
  /// that contains a box for which it holds.
  template <class Meets, class Visit>
  void query(const Meets& meets, Visit&& visit) const {
    query(meets, visit, [](std::uint32_t) { return false; });
  }
  /// The same without the items whose group satisfies skip(group).
  template <class Meets, class Visit, class Skip>
  void query(const Meets& meets, Visit&& visit, const Skip& skip) const {
    if (!empty() && meets(bounds_)) query(root(), meets, visit, skip);
  }

  /// Does the box of any item overlap another one?
  bool overlaps_any(const Box& box) const {
    return !empty() && bounds_.overlaps(box) && overlaps_any(root(), box);
  }

  /// A query where meets(node) tells it of all that is under a node, too. Of the parts of a node
  /// that one is visited first for which before(node, other) holds.
  template <class Meets, class Before, class Visit>
  void query_in_order(const Meets& meets, const Before& before, Visit&& visit) const {
    if (!empty()) query_in_order(root(), meets, before, visit);
  }
  /// The nodes below one that is no leaf, so that none comes for which before(it, an earlier one)
  /// holds: the first so many of them.
  template <class Before>
  std::pair<std::array<Node, width>, std::uint32_t> children_in_order(Node n,
                                                                      const Before& before) const {
    std::array<Node, width> children{};
    const std::uint32_t count = child_count(n);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Node next = child(n, i);
      std::uint32_t at = i;
      for (; at > 0 && before(next, children[at - 1]); --at) children[at] = children[at - 1];
      children[at] = next;
    }
    return {children, count};
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

  /// What more is known to be apart than boxes say: two nodes; of items of a leaf (bits) those
  /// which are not apart from what is in a box of the other tree, and those of b which are not
  /// apart from an item of a.
  struct NothingApart {
    bool nodes(Node, Node) const { return false; }
    unsigned near_in_a(std::uint32_t, unsigned items, const Box&) const { return items; }
    unsigned near_in_b(std::uint32_t, unsigned items, const Box&) const { return items; }
    unsigned near_item(std::uint32_t, unsigned, std::uint32_t, unsigned items) const {
      return items;
    }
  };
  /// The same without what `apart` knows to be apart.
  template <class Visit, class Skip, class Apart>
  static void overlaps(const BoxTree& a, const BoxTree& b, Visit&& visit, const Skip& skip,
                       const Apart& apart) {
    if (a.empty() || b.empty() || !a.bounds_.overlaps(b.bounds_)) return;
    overlaps(a, a.root(), a.bounds_, b, b.root(), b.bounds_, visit, skip, apart);
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
  /// The boxes of the nodes or items below a node.
  const FourBoxes& below(Node n) const { return boxes_[first_[n.level] + n.index]; }
  std::uint32_t group(Node n) const { return groups_[first_[n.level] + n.index]; }

  template <class Visit, class Skip, class Apart>
  static void overlaps(const BoxTree& a, Node p, const Box& box_of_p, const BoxTree& b, Node q,
                       const Box& box_of_q, Visit& visit, const Skip& skip, const Apart& apart);
  template <class Visit, class Skip, class Apart>
  static void overlaps_of_leaves(const BoxTree& a, std::uint32_t p, unsigned near_in_p,
                                 const BoxTree& b, std::uint32_t q, unsigned near_in_q,
                                 Visit& visit, const Skip& skip, const Apart& apart);
  bool has_groups() const { return !groups_.empty(); }
  template <class Skip>
  static bool skips(std::uint32_t group_of_a, std::uint32_t group_of_b, const Skip& skip) {
    return group_of_a != no_group && group_of_b != no_group && skip(group_of_a, group_of_b);
  }
  /// Calls visit(i), ascending, for all bits i that are set.
  template <class Visit>
  static void for_each_bit(unsigned bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<unsigned>(std::countr_zero(bits)));
  }
  void build_groups(const std::vector<std::uint32_t>& group);
  bool are_of_one_group(std::uint32_t i, std::uint32_t j) const {
    return has_groups() && item_groups_[i] != no_group && item_groups_[i] == item_groups_[j];
  }

  bool overlaps_any(Node n, const Box& box) const {
    for (unsigned bits = below(n).overlapping(box); bits != 0; bits &= bits - 1)
      if (n.level == 0 ||
          overlaps_any(child(n, static_cast<std::uint32_t>(std::countr_zero(bits))), box))
        return true;
    return false;
  }

  template <class Meets, class Visit, class Skip>
  void query(Node n, const Meets& meets, Visit& visit, const Skip& skip) const {
    const auto is_skipped = [&](std::uint32_t group) { return group != no_group && skip(group); };
    if (has_groups() && is_skipped(group(n))) return;
    if (n.level == 0) {
      visit_leaf(n, meets, [&](std::uint32_t i) {
        if (!has_groups() || !is_skipped(item_groups_[i])) visit(items_[i]);
      });
      return;
    }
    const std::uint32_t count = child_count(n);
    for (std::uint32_t i = 0; i < count; ++i)
      if (meets(below(n).get(i))) query(child(n, i), meets, visit, skip);
  }
  template <class Meets, class Before, class Visit>
  void query_in_order(Node n, const Meets& meets, const Before& before, Visit& visit) const {
    if (!meets(n)) return;
    if (n.level == 0) return visit_leaf(n, meets, [&](std::uint32_t i) { visit(items_[i]); });
    const auto [children, count] = children_in_order(n, before);
    for (std::uint32_t i = 0; i < count; ++i) query_in_order(children[i], meets, before, visit);
  }
  template <class Meets, class Visit>
  void visit_leaf(Node leaf, const Meets& meets, const Visit& visit) const {
    const auto from = leaf.index * width;
    const auto count = static_cast<std::uint32_t>(items(leaf).size());
    for (std::uint32_t i = 0; i < count; ++i)
      if (meets(below(leaf).get(i))) visit(from + i);
  }

  std::vector<std::uint32_t> items_;  // in the order of a curve
  std::vector<FourBoxes> boxes_;      // of what is below each node, leaves first, the root last
  std::vector<std::uint32_t> first_;  // per level, among all nodes; at last, the number of nodes
  Box bounds_;
  // The common group of all items of a node, or no_group. Empty if there are no groups.
  std::vector<std::uint32_t> item_groups_, groups_;
};

template <class Visit, class Apart>
void BoxTree::self_overlaps(const SelfPart& part, Visit&& visit, const Apart& apart) const {
  const Node p = part.p, q = part.q;
  if (p.level != q.level || p.index != q.index) {
    const Box box_of_p = box(p), box_of_q = box(q);
    if (!box_of_p.overlaps(box_of_q)) return;
    overlaps(
        *this, p, box_of_p, *this, q, box_of_q, visit,
        [](std::uint32_t g, std::uint32_t h) { return g == h; }, apart);
    return;
  }
  if (has_groups() && group(p) != no_group) return;
  const FourBoxes& boxes = below(p);
  const auto for_each_later = [&](unsigned i, const auto& visit_other) {
    for_each_bit(boxes.overlapping(boxes.get(i)) & (0xEu << i), visit_other);
  };
  if (p.level > 0) {
    const std::uint32_t count = child_count(p);
    for (std::uint32_t i = 0; i < count; ++i) {
      self_overlaps(SelfPart(child(p, i), child(p, i)), visit, apart);
      for_each_later(
          i, [&](unsigned j) { self_overlaps(SelfPart(child(p, i), child(p, j)), visit, apart); });
    }
    return;
  }
  const std::uint32_t first = p.index * width;
  for (std::uint32_t i = 0; i + 1 < items(p).size(); ++i)
    for_each_later(i, [&](unsigned j) {
      if (!are_of_one_group(first + i, first + j)) visit(items_[first + i], items_[first + j]);
    });
}

template <class Visit, class Skip, class Apart>
void BoxTree::overlaps(const BoxTree& a, Node p, const Box& box_of_p, const BoxTree& b, Node q,
                       const Box& box_of_q, Visit& visit, const Skip& skip, const Apart& apart) {
  if (a.has_groups() && b.has_groups() && skips(a.group(p), b.group(q), skip)) return;
  if (apart.nodes(p, q)) return;
  unsigned near_in_p = a.below(p).overlapping(box_of_q),
           near_in_q = b.below(q).overlapping(box_of_p);
  if (p.level == 0) near_in_p = apart.near_in_a(p.index, near_in_p, box_of_q);
  if (near_in_p == 0) return;
  if (q.level == 0) near_in_q = apart.near_in_b(q.index, near_in_q, box_of_p);
  if (near_in_q == 0) return;
  if (p.level == 0 && q.level == 0)
    return overlaps_of_leaves(a, p.index, near_in_p, b, q.index, near_in_q, visit, skip, apart);
  // The larger one first, so that large items meet nodes that are small beside them.
  if (p.level > 0 && (q.level == 0 || !box_of_q.is_larger_than(box_of_p)))
    for_each_bit(near_in_p, [&](unsigned i) {
      overlaps(a, child(p, i), a.below(p).get(i), b, q, box_of_q, visit, skip, apart);
    });
  else
    for_each_bit(near_in_q, [&](unsigned i) {
      overlaps(a, p, box_of_p, b, child(q, i), b.below(q).get(i), visit, skip, apart);
    });
}

template <class Visit, class Skip, class Apart>
void BoxTree::overlaps_of_leaves(const BoxTree& a, std::uint32_t p, unsigned near_in_p,
                                 const BoxTree& b, std::uint32_t q, unsigned near_in_q,
                                 Visit& visit, const Skip& skip, const Apart& apart) {
  const bool grouped = a.has_groups() && b.has_groups();
  const FourBoxes &boxes_of_p = a.below({0, p}), &boxes_of_q = b.below({0, q});
  for_each_bit(near_in_p, [&](unsigned k) {
    unsigned near = near_in_q & boxes_of_q.overlapping(boxes_of_p.get(k));
    if (near != 0) near = apart.near_item(p, k, q, near);
    for_each_bit(near, [&](unsigned l) {
      const std::uint32_t i = p * width + k, j = q * width + l;
      if (grouped && skips(a.item_groups_[i], b.item_groups_[j], skip)) return;
      visit(a.items_[i], b.items_[j]);
    });
  });
}

}  // namespace sectile
