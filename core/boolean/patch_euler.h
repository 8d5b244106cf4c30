// The Euler operators on a patch: what they make has its properties at once.
#pragma once

#include <cassert>

#include "boolean/patch.h"
#include "topology/euler.h"

namespace sectile {

/// See Euler. A face that is made is a part of the same loaded face as the one it was made from.
class PatchEuler {
 public:
  explicit PatchEuler(Patch& patch) : patch_(patch), euler_(patch.brep) {}

  /// Both parts of the edge lie in the planes of the whole. Returns the half-edge that goes on from
  /// the new vertex.
  HalfEdgeId divide(HalfEdgeId h, PointId point);

  // Null edges.
  HalfEdgeId mev(HalfEdgeId first, HalfEdgeId end) { return grown(euler_.mev(first, end)); }
  void mev_chain(std::span<const HalfEdgeId> first, HalfEdgeId end, std::vector<HalfEdgeId>& made) {
    euler_.mev_chain(first, end, made);
    patch_.side_plane.resize(patch_.brep.half_edge_count());
  }
  HalfEdgeId mevvr(FaceId face, PointId point) { return grown(euler_.mevvr(face, point)); }

  /// Edges within a face; `side` is a plane through the new edge, invalid for a null edge.
  HalfEdgeId mef(HalfEdgeId a, HalfEdgeId b, Euler::NewFace which, PlaneId side);
  HalfEdgeId connect(HalfEdgeId a, HalfEdgeId b, PlaneId side = {});

  void transfer_loop(LoopId loop, FaceId face) { euler_.transfer_loop(loop, face); }
  void move_loop(LoopId loop, FaceId face, bool outer) { euler_.move_loop(loop, face, outer); }

 private:
  // The planes through the two half-edges of an edge that was made.
  HalfEdgeId grown(HalfEdgeId made, PlaneId side = {}, PlaneId of_twin = {}) {
    assert(made == patch_.side_plane.end_id());
    patch_.side_plane.add(side);
    patch_.side_plane.add(of_twin);
    return made;
  }
  HalfEdgeId grown(HalfEdgeId made, FaceId root, PlaneId side);

  Patch& patch_;
  Euler euler_;
};

}  // namespace sectile
