// A tree over edges or polygons, which knows that they are apart where they are long and slanted,
// too.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "search/oriented_tree.h"

namespace sectile {

class PieceTree {
 public:
  /// Edges, each with its two ends, known up to half an ulp in each coordinate. Edges that are
  /// `along_curve` stay in the order in which they are.
  struct Edge {
    Vec3 from, to;
  };
  explicit PieceTree(std::span<const Edge> edges, bool along_curve = false);
  /// The same; edges of one group (per edge, or BoxTree::no_group) are no pairs in self_overlaps.
  PieceTree(std::span<const Edge> edges, const std::vector<std::uint32_t>& group);
  /// The convex hull of some points, at least one, as one piece.
  explicit PieceTree(std::span<const Vec3> hull);

  /// Calls visit(piece of a, piece of b) for all pairs that meet and for few others.
  template <class Visit>
  static void overlaps(const PieceTree& a, const PieceTree& b, Visit&& visit) {
    BoxTree::overlaps(
        a.tree_, b.tree_, visit, [](std::uint32_t, std::uint32_t) { return false; },
        OrientedApart(a.tree_, a.oriented(), b.tree_, b.oriented()));
  }
  /// The same for the pieces of one tree, each pair once.
  template <class Visit>
  void self_overlaps(Visit&& visit) const {
    const OrientedApart apart(tree_, oriented(), tree_, oriented());
    for (const auto& part : tree_.self_parts(1)) tree_.self_overlaps(part, visit, apart);
  }

 private:
  const OrientedTree* oriented() const { return oriented_ ? &*oriented_ : nullptr; }

  void build(std::span<const Edge> edges, const std::vector<std::uint32_t>& group,
             bool along_curve);

  BoxTree tree_;
  std::optional<OrientedTree> oriented_;
};

}  // namespace sectile
