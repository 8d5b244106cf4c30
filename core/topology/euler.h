// The Euler operators: the only way in which the algorithm changes a half-edge structure. Each
// keeps V - E + F - (L - F) = 2 (S - G), with L loops.
//
// The corner of a half-edge h is the sector of its face between h and the half-edge before it; it
// is named by h, which leaves the corner's vertex.
#pragma once

#include <span>
#include <vector>

#include "topology/brep.h"

namespace sectile {

class Euler {
 public:
  explicit Euler(Brep& brep) : brep_(brep) {}
  /// `followed`: faces whose ids are to be kept true. Of two that become one, both are that one.
  Euler(Brep& brep, std::span<FaceId> followed) : brep_(brep), followed_(followed) {}

  /// Split edge, make vertex: h now ends in the new vertex; the new half-edge goes on to where h
  /// ended. Returns the new vertex.
  VertexId semv(HalfEdgeId h, PointId point);

  /// Make edge and vertex: the half-edges that leave a vertex counter-clockwise from `first` up to,
  /// but without, `end` move to a new vertex at the same point (first == end: none of them).
  /// Returns the new half-edge from the old vertex to the new one; its twin lies in the corner
  /// clockwise of `first`, it itself in the corner clockwise of `end`.
  HalfEdgeId mev(HalfEdgeId first, HalfEdgeId end);

  /// A chain of vertices: mev(first[0], end), mev(first[1], twin of what that made), and so on; an
  /// invalid first moves no half-edge. Adds what they make to `made`. Each half-edge moves once.
  void mev_chain(std::span<const HalfEdgeId> first, HalfEdgeId end, std::vector<HalfEdgeId>& made);

  /// Make edge and face: a and b leave corners of one loop. The new half-edge runs from the corner
  /// of a to the corner of b and is returned; it is followed by b, its twin by a. One of the two
  /// loops goes to the new face, a copy of the old one: the shorter one if nothing else is said.
  enum class NewFace { shorter, left, right };
  HalfEdgeId mef(HalfEdgeId a, HalfEdgeId b, NewFace which = NewFace::shorter);

  /// Make edge, kill ring: as mef, for corners of two loops of one face, which become one loop.
  HalfEdgeId mekr(HalfEdgeId a, HalfEdgeId b);

  /// mef or mekr, as the loops demand.
  HalfEdgeId connect(HalfEdgeId a, HalfEdgeId b);

  /// Make edge, two vertices and ring: an edge between two new vertices, as a loop of its own in
  /// the face. Returns the half-edge from the first vertex to the second.
  HalfEdgeId mevvr(FaceId face, PointId point);

  /// Gives an inner loop of one part of a face to another part.
  void transfer_loop(LoopId loop, FaceId face);
  /// Gives a loop that is in no face's chain to a face, as its outer loop or as an inner one.
  void move_loop(LoopId loop, FaceId face, bool outer);

  /// Kill edge and face: the faces on both sides of h become one, h's.
  void kef(HalfEdgeId h);

  /// Kill edge, make ring: h has one loop on both sides; it falls into two loops of the face.
  /// Returns the new one, or an invalid id if one of the two would be empty: then, at a dangling
  /// end, edge and vertex are killed.
  LoopId kemr(HalfEdgeId h);

  /// Kill edge and vertex: a vertex with just two edges goes, and they become one, that of h, which
  /// leaves the vertex.
  void kev(HalfEdgeId h);

  /// Closes the gaps that killed entities leave in the tables, by moving the last ones there.
  void bury();

 private:
  void drop_edge(EdgeId e);
  void drop_loop(LoopId l);
  void unlink_loop(LoopId l);
  void move_edge(EdgeId from, EdgeId to);
  void move_face(FaceId from, FaceId to);
  void follow(FaceId from, FaceId to) {
    for (FaceId& f : followed_)
      if (f == from) f = to;
  }
  void move_loop_id(LoopId from, LoopId to);
  void move_vertex(VertexId from, VertexId to);

  HalfEdgeId add_edge(VertexId from, VertexId to);
  HalfEdgeId link_vertex(VertexId old, HalfEdgeId first, HalfEdgeId end);
  void link(HalfEdgeId before, HalfEdgeId after);
  HalfEdgeId cross_link(HalfEdgeId a, HalfEdgeId b);
  void label(HalfEdgeId member, LoopId loop);
  bool first_is_shorter(HalfEdgeId a, HalfEdgeId b) const;
  FaceId copy_face(FaceId face);
  LoopId add_loop(HalfEdgeId member, FaceId face);

  Brep& brep_;
  std::span<FaceId> followed_;
  std::vector<EdgeId> dead_edges_;
  std::vector<FaceId> dead_faces_;
  std::vector<LoopId> dead_loops_;
  std::vector<VertexId> dead_vertices_;
};

}  // namespace sectile
