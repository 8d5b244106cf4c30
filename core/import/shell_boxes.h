// Which shells can lie within which: only those whose boxes do.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "search/box_tree.h"
#include "search/oriented_tree.h"

namespace sectile {

class ShellBoxes {
 public:
  /// One box per shell. corners(shell) returns places around whose convex hull it is, at least one,
  /// known up to half an ulp: asked for where boxes are mostly empty.
  ShellBoxes(std::vector<Box> boxes,
             const std::function<std::vector<Vec3>(std::uint32_t)>& corners);

  /// Can this shell lie in any other one?
  bool is_held(std::uint32_t shell) const { return is_held_[shell] != 0; }
  std::size_t held_count() const {
    return static_cast<std::size_t>(std::count(is_held_.begin(), is_held_.end(), 1));
  }
  /// Can any other one lie in this shell?
  bool holds_any(std::uint32_t shell) const { return holds_any_[shell] != 0; }
  /// All shells, those that reach farthest along the x axis first.
  std::vector<std::uint32_t> farthest_first() const;

 private:
  // A tree over the shells, from which some are removed.
  class Tree {
   public:
    Tree(const ShellBoxes& shells, std::vector<std::uint32_t> order);

    /// Calls visit(shell) for all in which a shell can lie, and for itself, until it returns false.
    /// visit may remove the shell from the tree.
    template <class Visit>
    void around(std::uint32_t shell, const Visit& visit) const;
    void remove(std::uint32_t shell);

   private:
    const ShellBoxes& all_;
    std::vector<std::uint32_t> order_;  // the shells, as the tree takes them
    BoxTree tree_;
    std::optional<OrientedTree> oriented_;  // where boxes are mostly empty
    std::vector<std::uint32_t> place_;      // per shell, among all items of the tree
    std::vector<std::uint8_t> is_gone_;     // per shell
    std::vector<std::vector<Box>> left_;    // per level and node, around what is not gone
  };

  void find_held(const Tree& all);
  void find_holding(Tree& all);
  std::array<OrientedBox, 2> ends(std::uint32_t shell) const;
  bool is_oriented() const { return !corners_.empty(); }

  std::vector<Box> boxes_;
  std::vector<std::vector<Vec3>> corners_;  // where boxes are mostly empty
  std::vector<OrientedBox> oriented_;       // the same
  std::vector<std::uint8_t> is_held_, holds_any_;
};

}  // namespace sectile
