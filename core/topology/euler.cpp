#include "topology/euler.h"

#include <cassert>

namespace sectile {

HalfEdgeId Euler::add_edge(VertexId from, VertexId to) {
  const HalfEdgeId h = brep_.add_half_edge(from);
  brep_.add_half_edge(to);
  if (!brep_.edge_plane.empty()) brep_.edge_plane.add(PlaneId());
  return h;
}

void Euler::link(HalfEdgeId before, HalfEdgeId after) {
  brep_.next[before] = after;
  brep_.prev[after] = before;
}

void Euler::label(HalfEdgeId member, LoopId loop) {
  brep_.loop_half_edge[loop] = member;
  HalfEdgeId h = member;
  do {
    brep_.loop[h] = loop;
    h = brep_.next_of(h);
  } while (h != member);
}

// Walks both loops in step, so that the cost is that of the shorter one.
bool Euler::first_is_shorter(HalfEdgeId a, HalfEdgeId b) const {
  for (HalfEdgeId i = a, j = b;;) {
    i = brep_.next_of(i);
    if (i == a) return true;
    j = brep_.next_of(j);
    if (j == b) return false;
  }
}

FaceId Euler::copy_face(FaceId face) {
  if (!brep_.kind.empty()) brep_.kind.add(brep_.kind[face]);
  return brep_.add_face(brep_.plane[face], FaceSource(brep_.source[face]));
}

LoopId Euler::add_loop(HalfEdgeId member, FaceId face) {
  const LoopId loop = brep_.add_loop(face, member);
  LoopId& outer = brep_.outer_loop[face];
  if (outer.valid()) {
    brep_.next_loop[loop] = brep_.next_loop[outer];
    brep_.next_loop[outer] = loop;
  } else {
    outer = loop;
  }
  return loop;
}

VertexId Euler::semv(HalfEdgeId h, PointId point) {
  const HalfEdgeId back = Brep::twin(h);
  const VertexId end = brep_.from(back), middle(brep_.vertex_count());
  brep_.point.add(point);
  const HalfEdgeId on = add_edge(middle, end), on_back = Brep::twin(on);
  brep_.vertex_half_edge.add(on);
  if (!brep_.edge_plane.empty()) brep_.edge_plane.back() = brep_.edge_plane[Brep::edge_of(h)];
  brep_.origin[back] = middle;
  if (brep_.vertex_half_edge[end] == back) brep_.vertex_half_edge[end] = on_back;
  // At a dangling end the half-edge that follows h is its own twin.
  if (brep_.next_of(h) == back) {
    link(on, on_back);
  } else {
    link(on, brep_.next_of(h));
    link(brep_.prev_of(back), on_back);
  }
  link(h, on);
  link(on_back, back);
  brep_.loop[on] = brep_.loop_of(h);
  brep_.loop[on_back] = brep_.loop_of(back);
  return middle;
}

HalfEdgeId Euler::mev(HalfEdgeId first, HalfEdgeId end) {
  const VertexId old = brep_.from(first), made(brep_.vertex_count());
  assert(brep_.from(end) == old);
  for (HalfEdgeId h = first; h != end; h = brep_.around(h)) brep_.origin[h] = made;
  return link_vertex(old, first, end);
}

void Euler::mev_chain(std::span<const HalfEdgeId> first, HalfEdgeId end,
                      std::vector<HalfEdgeId>& made) {
  const std::size_t before = made.size();
  VertexId last = brep_.from(end);
  for (const HalfEdgeId h : first) {
    made.push_back(link_vertex(last, h.valid() ? h : end, end));
    end = Brep::twin(made.back());
    last = brep_.from(end);
  }
  // The cycles around the new vertices say which half-edges leave them.
  for (const HalfEdgeId out : std::span(made).subspan(before)) {
    const VertexId vertex = brep_.to(out);
    for_each_around(brep_, Brep::twin(out), [&](HalfEdgeId h) { brep_.origin[h] = vertex; });
  }
}

// All of mev but for the origins of the half-edges that move.
HalfEdgeId Euler::link_vertex(VertexId old, HalfEdgeId first, HalfEdgeId end) {
  const VertexId made(brep_.vertex_count());
  brep_.point.add(brep_.point_of(old));
  const HalfEdgeId out = add_edge(old, made), back = Brep::twin(out);
  brep_.vertex_half_edge.add(back);
  brep_.vertex_half_edge[old] = out;
  const HalfEdgeId into_first = Brep::twin(first), into_end = Brep::twin(end);
  const HalfEdgeId after_first = brep_.next_of(into_first), after_end = brep_.next_of(into_end);
  if (first == end) {
    link(into_end, out);
    link(out, back);
    link(back, after_end);
  } else {
    link(into_first, back);
    link(back, after_first);
    link(into_end, out);
    link(out, after_end);
  }
  brep_.loop[back] = brep_.loop_of(into_first);
  brep_.loop[out] = brep_.loop_of(into_end);
  return out;
}

HalfEdgeId Euler::cross_link(HalfEdgeId a, HalfEdgeId b) {
  const HalfEdgeId before_a = brep_.prev_of(a), before_b = brep_.prev_of(b);
  const HalfEdgeId h = add_edge(brep_.from(a), brep_.from(b)), back = Brep::twin(h);
  link(before_a, h);
  link(h, b);
  link(before_b, back);
  link(back, a);
  return h;
}

HalfEdgeId Euler::mef(HalfEdgeId a, HalfEdgeId b, NewFace which) {
  assert(a != b && brep_.loop_of(a) == brep_.loop_of(b));
  const LoopId old = brep_.loop_of(a);
  const FaceId face = brep_.loop_face[old];
  const HalfEdgeId h = cross_link(a, b), back = Brep::twin(h);
  const bool forward =
      which == NewFace::left || (which == NewFace::shorter && first_is_shorter(h, back));
  const HalfEdgeId kept = forward ? back : h, gone = forward ? h : back;
  brep_.loop[kept] = old;
  brep_.loop_half_edge[old] = kept;
  label(gone, add_loop(gone, copy_face(face)));
  return h;
}

HalfEdgeId Euler::mekr(HalfEdgeId a, HalfEdgeId b) {
  const LoopId loop_a = brep_.loop_of(a), loop_b = brep_.loop_of(b);
  assert(loop_a != loop_b && brep_.loop_face[loop_a] == brep_.loop_face[loop_b]);
  const bool a_goes = first_is_shorter(a, b);
  const LoopId gone = a_goes ? loop_a : loop_b, kept = a_goes ? loop_b : loop_a;
  label(a_goes ? a : b, kept);
  brep_.loop_half_edge[gone] = HalfEdgeId();
  const HalfEdgeId h = cross_link(a, b);
  brep_.loop[h] = brep_.loop[Brep::twin(h)] = kept;
  brep_.loop_half_edge[kept] = h;
  return h;
}

HalfEdgeId Euler::connect(HalfEdgeId a, HalfEdgeId b) {
  return brep_.loop_of(a) == brep_.loop_of(b) ? mef(a, b) : mekr(a, b);
}

HalfEdgeId Euler::mevvr(FaceId face, PointId point) {
  const VertexId first(brep_.vertex_count()), second(brep_.vertex_count() + 1);
  brep_.point.add(point);
  brep_.point.add(point);
  const HalfEdgeId h = add_edge(first, second), back = Brep::twin(h);
  brep_.vertex_half_edge.add(h);
  brep_.vertex_half_edge.add(back);
  link(h, back);
  link(back, h);
  const LoopId loop = add_loop(h, face);
  brep_.loop[h] = brep_.loop[back] = loop;
  return h;
}

void Euler::move_loop(LoopId loop, FaceId face, bool outer) {
  brep_.loop_face[loop] = face;
  LoopId& head = brep_.outer_loop[face];
  if (outer || !head.valid()) {
    brep_.next_loop[loop] = head;
    head = loop;
  } else {
    brep_.next_loop[loop] = brep_.next_loop[head];
    brep_.next_loop[head] = loop;
  }
}

}  // namespace sectile
