// The pairs of a triangle in a flat patch and one that is not in it.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "search/box_tree.h"
#include "selftest/flat_patches.h"
#include "selftest/slanted_nodes.h"
#include "selftest/triangle_tree.h"

namespace sectile {

class PatchPairs {
 public:
  /// `rest`: of the triangles in no patch.
  PatchPairs(const FlatPatches& patches, const TriangleSurface& surface, const Geometry& geometry,
             const TriangleTree& rest);

  std::size_t count() const { return own_.size(); }
  /// Calls visit(s, t) for all pairs that may meet of a patch's triangle and one of no patch, or of
  /// a patch that is left to this one: for each two patches, one is left to the other. Each pair is
  /// visited once for all patches.
  template <class Visit>
  void for_each_pair(std::size_t patch, const Visit& visit) const {
    beside(patch, rest_, visit);
    for (const std::uint32_t other : left_to_[patch]) beside(patch, own_[other].tree, visit);
  }

 private:
  struct Own {
    TriangleTree tree;
    SlantedNodes slanted;
  };
  // Of a node of a patch and a triangle.
  struct NotOriented {
    bool operator()(std::size_t, std::size_t) const { return false; }
  };
  struct Oriented {
    const SlantedNodes& nodes;
    OrientedBox box;
    bool operator()(std::size_t level, std::size_t node) const {
      return nodes.apart(level, node, box);
    }
  };

  OrientedBox around(std::uint32_t triangle) const;

  template <class Visit>
  void beside(std::size_t patch, const TriangleTree& tree, const Visit& visit) const {
    if (tree.order().empty()) return;
    beside(patch, tree, tree.levels() - 1, 0, visit);
  }
  template <class Visit>
  void beside(std::size_t patch, const TriangleTree& tree, std::size_t level, std::size_t node,
              const Visit& visit) const {
    const EightBoxes& boxes = tree.boxes(level, node);
    for (unsigned bits = boxes.overlapping(boxes_[patch]); bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      const Box box = boxes.get(i);
      if (patches_.is_beside(box, patch)) continue;
      if (level > 0) {
        beside(patch, tree, level - 1, 8 * node + i, visit);
      } else if (const std::uint32_t t = tree.order()[8 * node + i];
                 !patches_.stands_on(t, patch)) {
        const Own& own = own_[patch];
        const auto meet = [&](std::uint32_t s) { visit(s, t); };
        if (own.slanted.any())
          within(own, own.tree.levels() - 1, 0, box, Oriented{own.slanted, around(t)}, meet);
        else
          within(own, own.tree.levels() - 1, 0, box, NotOriented(), meet);
      }
    }
  }
  template <class Apart, class Visit>
  void within(const Own& own, std::size_t level, std::size_t node, const Box& box,
              const Apart& apart, const Visit& visit) const {
    for (unsigned bits = own.tree.boxes(level, node).overlapping(box); bits != 0;
         bits &= bits - 1) {
      const std::size_t child = 8 * node + static_cast<unsigned>(std::countr_zero(bits));
      if (level == 0)
        visit(own.tree.order()[child]);
      else if (!apart(level - 1, child))
        within(own, level - 1, child, box, apart, visit);
    }
  }

  const FlatPatches& patches_;
  const TriangleSurface& surface_;
  const Geometry& geometry_;
  const TriangleTree& rest_;
  std::vector<Own> own_;                             // per patch
  std::vector<Box> boxes_;                           // per patch
  std::vector<std::vector<std::uint32_t>> left_to_;  // per patch: smaller ones near it
};

}  // namespace sectile
