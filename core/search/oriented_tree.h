// Oriented boxes for the nodes of a box tree: where things are long, thin and slanted,
// axis-parallel boxes say little.
#pragma once

#include <vector>

#include "search/box_tree.h"
#include "search/oriented_box.h"

namespace sectile {

class OrientedTree {
 public:
  /// for_each_point(item, add) calls add(point) for points around whose convex hull an item is.
  template <class ForEachPoint>
  OrientedTree(const BoxTree& tree, const ForEachPoint& for_each_point)
      : levels_(tree.level_count()) {
    std::vector<Vec3> points;
    for (std::uint32_t level = 0; level < tree.level_count(); ++level)
      for (std::uint32_t i = 0; i < tree.node_count(level); ++i) {
        points.clear();
        for (const std::uint32_t item : tree.items({level, i}))
          for_each_point(item, [&](const Vec3& p) { points.push_back(p); });
        levels_[level].push_back(OrientedBox(points));
      }
  }
  const OrientedBox& operator[](BoxTree::Node n) const { return levels_[n.level][n.index]; }

 private:
  std::vector<std::vector<OrientedBox>> levels_;
};

/// Which nodes of two box trees are apart, by the oriented boxes of those that have them (not
/// null).
class OrientedApart : public BoxTree::NothingApart {
 public:
  OrientedApart(const BoxTree& a, const OrientedTree* oriented_a, const BoxTree& b,
                const OrientedTree* oriented_b)
      : a_(a), b_(b), oriented_a_(oriented_a), oriented_b_(oriented_b) {}

  bool nodes(BoxTree::Node p, BoxTree::Node q) const {
    if (oriented_a_ && oriented_b_) return apart((*oriented_a_)[p], (*oriented_b_)[q]);
    if (oriented_a_) return apart((*oriented_a_)[p], OrientedBox(b_.box(q)));
    if (oriented_b_) return apart(OrientedBox(a_.box(p)), (*oriented_b_)[q]);
    return false;
  }

 private:
  const BoxTree &a_, &b_;
  const OrientedTree *oriented_a_, *oriented_b_;
};

}  // namespace sectile
