// The Euler operators that take away.
#include <algorithm>

#include "topology/euler.h"

namespace sectile {

void Euler::drop_edge(EdgeId e) {
  for (unsigned side = 0; side < 2; ++side) {
    const HalfEdgeId h = Brep::half_edge(e, side);
    VertexId& origin = brep_.origin[h];
    // The next half-edge of the vertex that is not this one.
    if (brep_.vertex_half_edge[origin] == h)
      brep_.vertex_half_edge[origin] = brep_.next_of(Brep::twin(h));
  }
  dead_edges_.push_back(e);
}

void Euler::unlink_loop(LoopId l) {
  LoopId* at = &brep_.outer_loop[brep_.loop_face[l]];
  while (*at != l) at = &brep_.next_loop[*at];
  *at = brep_.next_loop[l];
}

void Euler::transfer_loop(LoopId loop, FaceId face) {
  unlink_loop(loop);
  move_loop(loop, face, false);
}

void Euler::drop_loop(LoopId l) {
  unlink_loop(l);
  dead_loops_.push_back(l);
}

void Euler::kef(HalfEdgeId h) {
  const HalfEdgeId back = Brep::twin(h);
  const FaceId kept = brep_.face_of(h), gone = brep_.face_of(back);
  const LoopId kept_outer = brep_.outer_loop[kept];
  LoopId loop = brep_.loop_of(h), other = brep_.loop_of(back);
  // If h bounds its face from outside and the other face from inside, the other's outer loop bounds
  // both.
  const bool other_surrounds = other != brep_.outer_loop[gone];
  const LoopId outer = other_surrounds ? brep_.outer_loop[gone] : kept_outer;
  const HalfEdgeId start = brep_.next_of(h) != back ? brep_.next_of(h) : brep_.next_of(back);
  drop_edge(Brep::edge_of(h));
  link(brep_.prev_of(h), brep_.next_of(back));
  link(brep_.prev_of(back), brep_.next_of(h));
  std::vector<LoopId> moved;
  for (LoopId l = brep_.outer_loop[gone]; l.valid(); l = brep_.next_loop[l]) moved.push_back(l);
  brep_.outer_loop[gone] = LoopId();
  for (const LoopId l : moved) move_loop(l, kept, false);
  if (other_surrounds) {
    unlink_loop(outer);
    move_loop(outer, kept, true);
  }
  drop_loop(other);
  label(start, loop);
  dead_faces_.push_back(gone);
  follow(gone, kept);
}

LoopId Euler::kemr(HalfEdgeId h) {
  const HalfEdgeId back = Brep::twin(h);
  const LoopId loop = brep_.loop_of(h);
  const FaceId face = brep_.loop_face[loop];
  const HalfEdgeId after = brep_.next_of(h), after_back = brep_.next_of(back);
  const bool ends_at_h = after == back, ends_at_back = after_back == h;
  if (ends_at_h || ends_at_back) {  // a dangling end
    const HalfEdgeId stays = ends_at_h ? after_back : after;
    const VertexId end = ends_at_h ? brep_.to(h) : brep_.from(h);
    if (ends_at_h && ends_at_back) {  // nothing else in the loop
      dead_vertices_.push_back(brep_.from(h));
      dead_vertices_.push_back(brep_.to(h));
      dead_edges_.push_back(Brep::edge_of(h));
      drop_loop(loop);
      return {};
    }
    drop_edge(Brep::edge_of(h));
    dead_vertices_.push_back(end);
    link(ends_at_h ? brep_.prev_of(h) : brep_.prev_of(back), stays);
    brep_.loop_half_edge[loop] = stays;
    return {};
  }
  drop_edge(Brep::edge_of(h));
  link(brep_.prev_of(h), after_back);
  link(brep_.prev_of(back), after);
  brep_.loop_half_edge[loop] = after_back;
  const LoopId made = add_loop(after, face);
  label(after, made);
  return made;
}

void Euler::kev(HalfEdgeId h) {
  // a <-- h -- v -- g --> b
  const HalfEdgeId into = Brep::twin(h), g = brep_.next_of(into), back = Brep::twin(g);
  const VertexId v = brep_.from(h), b = brep_.from(back);
  brep_.origin[h] = b;
  if (brep_.vertex_half_edge[b] == back) brep_.vertex_half_edge[b] = h;
  for (const auto& [gone, stays] : {std::pair{g, into}, std::pair{back, h}}) {
    const LoopId l = brep_.loop_of(gone);
    if (brep_.loop_half_edge[l] == gone) brep_.loop_half_edge[l] = stays;
  }
  // A dangling path ends in b.
  link(into, brep_.next_of(g) == back ? h : brep_.next_of(g));
  if (brep_.next_of(g) != back) link(brep_.prev_of(back), h);
  dead_edges_.push_back(Brep::edge_of(g));
  dead_vertices_.push_back(v);
}

void Euler::move_edge(EdgeId from, EdgeId to) {
  const auto moved = [&](HalfEdgeId h) {
    return Brep::edge_of(h) == from ? Brep::half_edge(to, h.value() & 1u) : h;
  };
  for (unsigned side = 0; side < 2; ++side) {
    const HalfEdgeId f = Brep::half_edge(from, side), t = Brep::half_edge(to, side);
    brep_.origin[t] = brep_.origin[f];
    brep_.loop[t] = brep_.loop[f];
    link(t, moved(brep_.next_of(f)));
    link(moved(brep_.prev_of(f)), t);
    HalfEdgeId& of_vertex = brep_.vertex_half_edge[brep_.origin[f]];
    if (of_vertex == f) of_vertex = t;
    HalfEdgeId& of_loop = brep_.loop_half_edge[brep_.loop[f]];
    if (of_loop == f) of_loop = t;
  }
  if (!brep_.edge_plane.empty()) brep_.edge_plane[to] = brep_.edge_plane[from];
}

void Euler::move_face(FaceId from, FaceId to) {
  brep_.outer_loop[to] = brep_.outer_loop[from];
  brep_.plane[to] = brep_.plane[from];
  brep_.source[to] = brep_.source[from];
  if (!brep_.kind.empty()) brep_.kind[to] = brep_.kind[from];
  for (LoopId l = brep_.outer_loop[to]; l.valid(); l = brep_.next_loop[l]) brep_.loop_face[l] = to;
  follow(from, to);
}

void Euler::move_loop_id(LoopId from, LoopId to) {
  LoopId* at = &brep_.outer_loop[brep_.loop_face[from]];
  while (*at != from) at = &brep_.next_loop[*at];
  *at = to;
  brep_.loop_half_edge[to] = brep_.loop_half_edge[from];
  brep_.loop_face[to] = brep_.loop_face[from];
  brep_.next_loop[to] = brep_.next_loop[from];
  for_each_in_loop(brep_, to, [&](HalfEdgeId h) { brep_.loop[h] = to; });
}

void Euler::move_vertex(VertexId from, VertexId to) {
  brep_.point[to] = brep_.point[from];
  const HalfEdgeId first = brep_.vertex_half_edge[to] = brep_.vertex_half_edge[from];
  HalfEdgeId h = first;
  do {
    brep_.origin[h] = to;
    h = brep_.around(h);
  } while (h != first);
}

namespace {

// Calls move(last, dead) for all dead ids, largest first, so that the last one is always alive.
template <class Ids, class Move>
std::size_t fill_gaps(Ids& dead, std::size_t count, const Move& move) {
  std::sort(dead.begin(), dead.end());
  for (auto id = dead.rbegin(); id != dead.rend(); ++id) {
    --count;
    if (id->value() != count) move(typename Ids::value_type(count), *id);
  }
  dead.clear();
  return count;
}

}  // namespace

void Euler::bury() {
  const std::size_t edges = fill_gaps(dead_edges_, brep_.edge_count(),
                                      [&](EdgeId from, EdgeId to) { move_edge(from, to); });
  for (auto* ids : {&brep_.next, &brep_.prev}) ids->resize(2 * edges);
  brep_.origin.resize(2 * edges);
  brep_.loop.resize(2 * edges);
  if (!brep_.edge_plane.empty()) brep_.edge_plane.resize(edges);
  const std::size_t loops = fill_gaps(dead_loops_, brep_.loop_count(),
                                      [&](LoopId from, LoopId to) { move_loop_id(from, to); });
  brep_.loop_half_edge.resize(loops);
  brep_.loop_face.resize(loops);
  brep_.next_loop.resize(loops);
  const std::size_t faces = fill_gaps(dead_faces_, brep_.face_count(),
                                      [&](FaceId from, FaceId to) { move_face(from, to); });
  brep_.outer_loop.resize(faces);
  brep_.plane.resize(faces);
  brep_.source.resize(faces);
  if (!brep_.kind.empty()) brep_.kind.resize(faces);
  const std::size_t vertices =
      fill_gaps(dead_vertices_, brep_.vertex_count(),
                [&](VertexId from, VertexId to) { move_vertex(from, to); });
  brep_.vertex_half_edge.resize(vertices);
  brep_.point.resize(vertices);
}

}  // namespace sectile
