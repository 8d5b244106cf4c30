// The edges that a sweep over a plane crosses at one moment, from bottom to top.
//
// A search tree whose order is given by where edges are inserted, never by comparing two edges; a
// treap with priorities from a fixed sequence, so that equal input gives equal work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sectile {

class SweepLine {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /// For edges numbered 0 to edges - 1.
  explicit SweepLine(std::size_t edges) : nodes_(edges) {}

  bool empty() const { return root_ == none; }
  std::uint32_t below(std::uint32_t edge) const { return nodes_[edge].below; }
  std::uint32_t above(std::uint32_t edge) const { return nodes_[edge].above; }

  struct Gap {
    std::uint32_t below = none, above = none;
  };
  /// The gap between the edges for which is_below(edge) is true and those for which it is not.
  template <class IsBelow>
  Gap locate(const IsBelow& is_below) const {
    Gap gap;
    std::uint32_t at = root_;
    while (at != none) {
      if (is_below(at)) {
        gap.below = at;
        at = nodes_[at].right;
      } else {
        gap.above = at;
        at = nodes_[at].left;
      }
    }
    return gap;
  }

  /// Inserts an edge just above another, or as the lowest if that is none.
  void insert_above(std::uint32_t below, std::uint32_t edge);
  /// Puts an edge that is not in the line in the place of one that is.
  void replace(std::uint32_t old_edge, std::uint32_t new_edge);
  void remove(std::uint32_t edge);

 private:
  struct Node {
    std::uint32_t parent = none, left = none, right = none;
    std::uint32_t below = none, above = none;
    std::uint32_t priority = 0;
  };

  std::uint32_t next_priority();
  void set_child(std::uint32_t parent, std::uint32_t old_child, std::uint32_t new_child);
  void rotate_up(std::uint32_t edge);
  void link(std::uint32_t below, std::uint32_t above);

  std::vector<Node> nodes_;
  std::uint32_t root_ = none, lowest_ = none;
  std::uint32_t random_ = 0x9E3779B9u;
};

}  // namespace sectile
