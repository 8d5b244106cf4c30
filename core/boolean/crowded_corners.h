// Faces with very many corners in one point, as a floor has on which the spikes of a star stand.
//
// Around such a point all boxes of edges overlap. Of what is in a plane through it, and of what
// begins there, too, directions tell which edges it meets elsewhere.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boolean/corner_fan.h"
#include "boolean/entity.h"
#include "geometry/probe.h"
#include "search/piece_tree.h"

namespace sectile {

class CrowdedCorners {
 public:
  /// Vertices in one point, ascending.
  using Crowd = std::vector<VertexId>;
  /// A half-edge of the face belongs to the fans of both its ends, or to none.
  struct Fan {
    PointId point;  ///< of one of the vertices
    Vec3 place;     ///< rounded
    CornerFan corners;
    Crowd vertices;             ///< in that point; the first one stands for all
    std::vector<VertexId> met;  ///< of which a contact tells: the first one if one is tested
    /// For a vertex that is tested, if the face owns it; and one that leaves a vertex, for each
    /// that is tested for some of these.
    std::vector<HalfEdgeId> speak;
    std::vector<HalfEdgeId> edges;  ///< that begin or end there
    PieceTree tree;                 ///< of these
  };

  /// A face with many half-edges, of which very many begin in each of these crowds.
  CrowdedCorners(const Kernel& kernel, const Patch& patch, const Geometry& geometry,
                 std::span<const HalfEdgeId> half_edges, const std::vector<Crowd>& crowds);

  std::span<const Fan> fans() const { return fans_; }
  /// The one with a vertex; null if there is none.
  const Fan* at(VertexId v) const;

  /// For a point of the face's plane that is such a point: adds the vertices there, and whatever
  /// else of the boundary it lies on. False for other points.
  bool touch(const Kernel& kernel, const Patch& patch, PlaneId plane, const Probe& point,
             std::vector<Entity>& found) const;

  /// Calls visit(half-edge) for those of a fan that come near something, and for few others.
  template <class Visit>
  static void query(const Fan& fan, const PieceTree& what, const Visit& visit) {
    overlaps(fan.tree, fan.edges, what, visit);
  }
  /// The same for those of no fan.
  template <class Visit>
  void query_others(const PieceTree& what, const Visit& visit) const {
    if (tree_of_others_) overlaps(*tree_of_others_, others_, what, visit);
  }

 private:
  template <class Visit>
  static void overlaps(const PieceTree& tree, std::span<const HalfEdgeId> edges,
                       const PieceTree& what, const Visit& visit) {
    PieceTree::overlaps(tree, what, [&](std::uint32_t i, std::uint32_t) { visit(edges[i]); });
  }

  std::vector<Fan> fans_;  // few
  std::vector<HalfEdgeId> others_;
  std::optional<PieceTree> tree_of_others_;  // none if there are none
};

/// Finds those of the faces of a patch that have outlines. It is known what is tested.
void find_crowded_corners(Patch& patch, const Geometry& geometry, const Kernel& kernel);

}  // namespace sectile
