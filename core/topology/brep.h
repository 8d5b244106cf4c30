// The half-edge boundary representation, as structure of arrays with 32-bit ids.
//
// An edge is the pair of half-edges 2e and 2e + 1. A half-edge runs from its origin with the face
// on its left, seen from outside. A face has one outer loop and any number of inner loops, chained
// by next_loop; the outer loop comes first. See docs/half-edges.md for the invariants.
#pragma once

#include "numbers/id.h"
#include "numbers/table.h"
#include "sectile/solid.h"

namespace sectile {

enum class FaceKind : std::uint8_t {
  real,  ///< part of the boundary of the solid
  null,  ///< a face without area between null edges and the two sides of a cut
  rest   ///< stands for all that is not loaded beyond an open end of a patch
};

class Brep {
 public:
  // Per half-edge.
  Table<HalfEdgeId, VertexId> origin;
  Table<HalfEdgeId, HalfEdgeId> next, prev;
  Table<HalfEdgeId, LoopId> loop;
  // Per edge: a plane through the edge that is not parallel to its faces, for edges between
  // coplanar faces whose end points do not say it; otherwise invalid. Empty if there is none at
  // all.
  Table<EdgeId, PlaneId> edge_plane;
  // Per loop. A killed loop stays in its face's chain without a half-edge.
  Table<LoopId, HalfEdgeId> loop_half_edge;
  Table<LoopId, FaceId> loop_face;
  Table<LoopId, LoopId> next_loop;
  // Per face.
  Table<FaceId, LoopId> outer_loop;
  Table<FaceId, PlaneId> plane;
  Table<FaceId, FaceSource> source;
  Table<FaceId, FaceKind> kind;  ///< empty if all faces are real
  // Per vertex.
  Table<VertexId, HalfEdgeId> vertex_half_edge;  ///< one of the half-edges that leave it
  Table<VertexId, PointId> point;

  std::size_t half_edge_count() const { return origin.size(); }
  std::size_t edge_count() const { return origin.size() / 2; }
  std::size_t loop_count() const { return loop_half_edge.size(); }
  std::size_t face_count() const { return outer_loop.size(); }
  std::size_t vertex_count() const { return point.size(); }
  IdRange<HalfEdgeId> half_edges() const { return origin.ids(); }
  IdRange<EdgeId> edges() const { return {EdgeId(0), EdgeId(edge_count())}; }
  IdRange<LoopId> loops() const { return loop_half_edge.ids(); }
  IdRange<FaceId> faces() const { return outer_loop.ids(); }
  IdRange<VertexId> vertices() const { return point.ids(); }

  /// Room for so many more edges, faces with one loop each, and vertices.
  void reserve(std::size_t edges, std::size_t faces, std::size_t vertices);
  void reserve_faces(std::size_t faces);
  /// New elements have no links; edge_plane and kind stay as they are.
  void resize_half_edges(std::size_t count);
  void resize_faces(std::size_t count);
  void resize_loops(std::size_t count);
  /// Without links; two make an edge.
  HalfEdgeId add_half_edge(VertexId from);
  /// A face with its outer loop, which may come later; `kind` stays as it is.
  FaceId add_face(PlaneId of_plane, const FaceSource& of_source, LoopId outer = {});
  /// A loop of a face, and the one after it in the face's chain.
  LoopId add_loop(FaceId face, HalfEdgeId first = {}, LoopId next_in_face = {});

  static HalfEdgeId twin(HalfEdgeId h) { return HalfEdgeId(h.value() ^ 1u); }
  static EdgeId edge_of(HalfEdgeId h) { return EdgeId(h.value() >> 1); }
  static HalfEdgeId half_edge(EdgeId e, unsigned side = 0) {
    return HalfEdgeId(2 * e.value() + side);
  }
  VertexId from(HalfEdgeId h) const { return origin[h]; }
  VertexId to(HalfEdgeId h) const { return origin[twin(h)]; }
  HalfEdgeId next_of(HalfEdgeId h) const { return next[h]; }
  HalfEdgeId prev_of(HalfEdgeId h) const { return prev[h]; }
  LoopId loop_of(HalfEdgeId h) const { return loop[h]; }
  FaceId face_of(HalfEdgeId h) const { return loop_face[loop[h]]; }
  PlaneId plane_of(HalfEdgeId h) const { return plane[face_of(h)]; }
  PointId point_of(VertexId v) const { return point[v]; }
  FaceKind kind_of(FaceId f) const { return kind.empty() ? FaceKind::real : kind[f]; }
  PlaneId extra_plane(EdgeId e) const { return edge_plane.empty() ? PlaneId() : edge_plane[e]; }
  /// The half-edge that leaves the same vertex next in counter-clockwise order, seen from outside.
  HalfEdgeId around(HalfEdgeId h) const { return twin(prev_of(h)); }
};

inline void Brep::reserve(std::size_t edges, std::size_t faces, std::size_t vertices) {
  const auto add = [](auto& table, std::size_t more) { table.reserve(table.size() + more); };
  add(origin, 2 * edges);
  add(next, 2 * edges);
  add(prev, 2 * edges);
  add(loop, 2 * edges);
  if (!edge_plane.empty()) add(edge_plane, edges);
  reserve_faces(faces);
  add(vertex_half_edge, vertices);
  add(point, vertices);
}

inline void Brep::reserve_faces(std::size_t faces) {
  const auto add = [&](auto& table) { table.reserve(table.size() + faces); };
  add(loop_half_edge);
  add(loop_face);
  add(next_loop);
  add(outer_loop);
  add(plane);
  add(source);
  if (!kind.empty()) add(kind);
}

inline void Brep::resize_half_edges(std::size_t count) {
  origin.resize(count);
  next.resize(count);
  prev.resize(count);
  loop.resize(count);
}

inline HalfEdgeId Brep::add_half_edge(VertexId from) {
  next.add({});
  prev.add({});
  loop.add({});
  return origin.add(from);
}

inline void Brep::resize_faces(std::size_t count) {
  outer_loop.resize(count);
  plane.resize(count);
  source.resize(count);
}

inline void Brep::resize_loops(std::size_t count) {
  loop_half_edge.resize(count);
  loop_face.resize(count);
  next_loop.resize(count);
}

inline FaceId Brep::add_face(PlaneId of_plane, const FaceSource& of_source, LoopId outer) {
  plane.add(of_plane);
  source.add(of_source);
  return outer_loop.add(outer);
}

inline LoopId Brep::add_loop(FaceId face, HalfEdgeId first, LoopId next_in_face) {
  loop_face.add(face);
  next_loop.add(next_in_face);
  return loop_half_edge.add(first);
}

/// Calls visit(HalfEdgeId) for every half-edge of a loop, in order.
template <class Visit>
void for_each_in_loop(const Brep& brep, LoopId loop, Visit&& visit) {
  const HalfEdgeId first = brep.loop_half_edge[loop];
  if (!first.valid()) return;
  for (HalfEdgeId h = first;;) {
    visit(h);
    h = brep.next_of(h);
    if (h == first) break;
  }
}

/// Calls visit(HalfEdgeId) for every half-edge of a face, loop by loop, the outer loop first.
template <class Visit>
void for_each_in_face(const Brep& brep, FaceId face, Visit&& visit) {
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l])
    for_each_in_loop(brep, l, visit);
}

/// Calls visit(HalfEdgeId) for every half-edge that leaves the origin of one, counter-clockwise.
template <class Visit>
void for_each_around(const Brep& brep, HalfEdgeId first, Visit&& visit) {
  HalfEdgeId h = first;
  do {
    visit(h);
    h = brep.around(h);
  } while (h != first);
}

}  // namespace sectile
