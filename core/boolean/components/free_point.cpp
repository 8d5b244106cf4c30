#include "boolean/components/free_point.h"

#include <algorithm>
#include <tuple>

#include "boolean/components/point_in_face.h"
#include "boolean/line.h"
#include "geometry/axes.h"
#include "geometry/probe.h"
#include "search/edges_by_line.h"

namespace sectile {
namespace {

// Of a shell, which takes one as a rule.
constexpr std::size_t most_points = 4;

}  // namespace

FreePoints::FreePoints(Workspace& w, const Contacts& contacts, Operand operand)
    : w_(w),
      operand_(operand),
      patch_(w.patch[operand]),
      brep_(patch_.brep),
      seen_(brep_.face_count()),
      vertex_in_contact_(brep_.vertex_count()),
      edge_in_contact_(brep_.edge_count()),
      face_in_contact_(brep_.face_count()) {
  for (const Contact& c : contacts.contacts) {
    const Entity mine = c.on[operand];
    if (mine.is_vertex()) vertex_in_contact_[mine.vertex()] = 1;
    if (mine.is_edge()) edge_in_contact_[mine.edge()] = 1;
    if (mine.is_face()) face_in_contact_[mine.face()] = 1;
  }
  add_crowded_lines();
  add_crowded_points();
  if (!patch_.tested.any()) return;
  for (const VertexId v : vertex_in_contact_.ids())
    vertex_in_contact_[v] |= vertex_in_contact_[patch_.tested(v)];
  for (const EdgeId e : edge_in_contact_.ids())
    edge_in_contact_[e] |= edge_in_contact_[patch_.tested(e)];
}

// There, contacts do not tell all that meets.
void FreePoints::add_crowded_lines() {
  const auto& on_line = patch_.on_crowded_line;
  for (const VertexId v : on_line.ids()) vertex_in_contact_[v] |= on_line[v];
  for (const EdgeId e : brep_.edges()) {
    const HalfEdgeId h = Brep::half_edge(e);
    const VertexId from = brep_.from(h), to = brep_.to(h);
    if (from.value() >= on_line.size() || to.value() >= on_line.size()) continue;
    const std::uint32_t one = on_line[from], two = on_line[to];
    if (one == 0 || two == 0) continue;
    const bool maybe = one == Patch::several || two == Patch::several;
    if (maybe ? are_on_crowded_line({brep_.point_of(from), brep_.point_of(to)}) : one == two)
      edge_in_contact_[e] = 1;
  }
}

bool FreePoints::are_on_crowded_line(std::initializer_list<PointId> points) const {
  return std::ranges::any_of(w_.crowded_lines, [&](const auto& line) {
    return std::ranges::all_of(
        points, [&](PointId p) { return are_on_one_line(w_.tests(), line[0], line[1], p); });
  });
}

void FreePoints::add_crowded_points() {
  if (w_.crowded_points.empty()) return;
  for (const VertexId v : brep_.vertices())
    if (is_crowded_point(brep_.point_of(v))) vertex_in_contact_[v] = 1;
}

bool FreePoints::is_crowded_point(PointId p) const {
  const auto place = [&](PointId q) {
    const Vec3& at = w_.geometry.position(q);
    return std::tuple(at.x, at.y, at.z);
  };
  auto point = std::ranges::lower_bound(w_.crowded_points, place(p), {}, place);
  for (; point != w_.crowded_points.end() && place(*point) == place(p); ++point)
    if (w_.tests().same_point(p, *point)) return true;
  return false;
}

bool FreePoints::is_where_pairs_were_left_out(PointId p) const {
  return are_on_crowded_line({p}) || is_crowded_point(p);
}

std::vector<PointId> FreePoints::on_shell_of(FaceId start) {
  faces_.clear();
  front_.assign(1, start);
  seen_[start] = 1;
  std::vector<EdgeId> edges;
  std::vector<PointId> found;
  PointId beyond_end;
  while (!beyond_end.valid() && found.size() < most_points && visit_next()) {
    for_each_in_face(brep_, faces_.back(), [&](HalfEdgeId h) {
      const VertexId v = brep_.from(h);
      edges.push_back(Brep::edge_of(h));
      if (!vertex_in_contact_[v] && found.size() < most_points &&
          std::ranges::find(found, brep_.point_of(v)) == found.end())
        found.push_back(brep_.point_of(v));
      if (found.empty() && !beyond_end.valid() &&
          brep_.kind_of(brep_.face_of(Brep::twin(h))) == FaceKind::rest)
        beyond_end = corner_beyond(patch_.half_edge_in_solid[Brep::twin(h)]);
    });
  }
  w_.kernel->refresh();
  if (!found.empty()) return found;
  PointId only = beyond_end.valid() ? beyond_end : within_an_edge(edges);
  if (!only.valid()) only = within_a_face();
  if (!only.valid()) throw NeedsAllPairs("a shell lies on the other boundary without a contact");
  return {only};
}

bool FreePoints::visit_next() {
  if (front_.empty()) return false;
  const FaceId face = front_.back();
  front_.pop_back();
  faces_.push_back(face);
  for_each_in_face(brep_, face, [&](HalfEdgeId h) {
    const FaceId beyond = brep_.face_of(Brep::twin(h));
    if (!patch_.is_real(beyond) || seen_[beyond]) return;
    seen_[beyond] = 1;
    front_.push_back(beyond);
  });
  return true;
}

PointId FreePoints::facing_x() {
  for (std::size_t i = 0; i < faces_.size() || visit_next(); ++i) {
    if (face_in_contact_[faces_[i]] || w_.tests().main_axis(patch_.plane(faces_[i])) != 0) continue;
    const PointId made = within(faces_[i], 0.5);
    if (made.valid()) return made;
  }
  return {};
}

// A corner, off the edge, of a face that is not loaded.
PointId FreePoints::corner_beyond(HalfEdgeId in_solid) {
  const SolidData& solid = *patch_.solid;
  const std::uint32_t s = solid.slot_of(in_solid);
  const Slot& slot = solid.slot(s);
  const Brep& brep = slot.block->brep();
  const HalfEdgeId h = solid.local(s, in_solid);
  const VertexId across = slot.turned ? brep.to(brep.next_of(h)) : brep.from(brep.prev_of(h));
  return load_point(slot.block->geometry(), brep.point_of(across), w_.geometry);
}

// A shell may touch the other boundary in all of its vertices. Its edges then lead away from it,
// and a plane across one of them gives a point that is free.
PointId FreePoints::within_an_edge(std::vector<EdgeId>& edges) {
  std::erase_if(edges, [&](EdgeId e) { return edge_in_contact_[e] != 0; });
  for (const EdgeId e : edges) {
    const HalfEdgeId h = Brep::half_edge(e);
    const PointId from = brep_.point_of(brep_.from(h)), to = brep_.point_of(brep_.to(h));
    for (int axis = 0; axis < 3; ++axis) {
      const double p = component(w_.geometry.position(from), axis),
                   q = component(w_.geometry.position(to), axis);
      const PlaneId across = plane_across(w_, axis, p / 2 + q / 2);
      if (w_.tests().side(from, across) * w_.tests().side(to, across) != Sign::negative) continue;
      const Construction how = edge_plane_construction(w_, operand_, h, across);
      const PointId made = add_constructed(w_.geometry, how, w_.tests().construct(how));
      w_.kernel->refresh();
      if (!is_where_pairs_were_left_out(made)) return made;
    }
  }
  return {};
}

// All edges may be on crowded lines, which what is within a face is not.
PointId FreePoints::within_a_face() {
  for (const FaceId face : faces_) {
    if (face_in_contact_[face]) continue;
    for (const double part : {0.5, 0.01}) {
      const PointId made = within(face, part);
      if (made.valid()) return made;
    }
  }
  return {};
}

PointId FreePoints::within(FaceId face, double part) {
  return point_in_face(w_, patch_, face, part,
                       [&](PointId p) { return !is_where_pairs_were_left_out(p); });
}

}  // namespace sectile
