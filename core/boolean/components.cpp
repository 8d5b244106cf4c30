#include "boolean/components.h"

#include "boolean/line.h"
#include "boolean/ray.h"
#include "boolean/tables.h"
#include "geometry/probe.h"
#include "search/id_map.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr std::uint8_t nothing = 0, unknown = RestLabels::unknown;

class Spreading {
 public:
  Spreading(Workspace& w, int s, const LabelOf& label_of, FaceLabels& labels)
      : w_(w),
        s_(s),
        label_(label_of),
        patch_(w.patch[s]),
        brep_(patch_.brep),
        loaded_(labels.loaded[s]),
        rest_(labels.rest[s]),
        open_ends_(64) {
    loaded_.assign(brep_.face_count(), unknown);
    seen_.assign(brep_.face_count(), 0);
    if (!patch_.unbounded) rest_ = RestLabels(patch_);
    if (!rest_.empty()) find_open_ends();
  }

  void run() {
    seed_from_segments();
    spread();
    visit_untouched_shells();
    for (std::size_t f = 0; f < loaded_.size(); ++f)
      if (!patch_.is_real(FaceId(f))) loaded_[f] = nothing;
  }

 private:
  const SolidData& solid() const { return *patch_.solid; }
  const Slot& slot(std::uint32_t s) const { return patch_.solid->slot(s); }

  void find_open_ends() {
    for (std::size_t i = 0; i < patch_.half_edge_in_solid.size(); ++i)
      if (const HalfEdgeId h = patch_.half_edge_in_solid[i]; h.valid())
        open_ends_[h.value()] = static_cast<std::uint32_t>(i);
  }

  // True if the label is new.
  static bool set(std::uint8_t& now, std::uint8_t label) {
    if (now == label) return false;
    if (now != unknown)
      throw InternalError("a piece of a boundary is kept by one cut, not by another");
    now = label;
    return true;
  }
  void set_loaded(FaceId f, std::uint8_t label) {
    if (set(loaded_[f.value()], label)) stack_.push_back({loaded_slot, f.value()});
  }
  void set_rest(std::uint32_t s, FaceId local, std::uint8_t label) {
    set_member(s, rest_.member(s, local), label);
  }
  void set_member(std::uint32_t s, std::uint32_t member, std::uint8_t label) {
    if (set(rest_.of_member(s, member), label)) stack_.push_back({s, member});
  }

  void seed_from_segments() {
    std::vector<std::uint8_t> cut(patch_.root.size(), 0);
    for (const Carrier& c : w_.carriers)
      if (c.cut && c.solid == s_)
        for (const HalfEdgeId h : {c.forward, c.backward})
          cut[patch_.root[brep_.face_of(h).value()].value()] = 1;
    for (const auto& [solid, root] : w_.bridged)
      if (solid == s_) cut[root.value()] = 1;
    for (const HalfPlane& h : w_.half_planes) {
      if (h.solid != s_) continue;
      const std::uint8_t label = label_(s_, h.cls);
      const Carrier& c = w_.carriers[h.carrier];
      // Beside a cut the part is known; elsewhere only a face that was not divided.
      if (c.cut)
        set_loaded(brep_.face_of(h.forward ? c.forward : c.backward), label);
      else if (!cut[h.face.value()])
        set_loaded(h.face, label);
    }
  }

  void spread() {
    while (!stack_.empty()) {
      const Pending next = stack_.back();
      stack_.pop_back();
      if (next.slot == loaded_slot)
        spread_loaded(FaceId(next.member));
      else if (rest_.is_touched(next.slot))
        spread_face(next.slot, FaceId(next.member));
      else
        spread_piece(next.slot, next.member);
    }
  }

  void spread_loaded(FaceId face) {
    const std::uint8_t label = loaded_[face.value()];
    for_each_in_face(brep_, face, [&](HalfEdgeId h) {
      const HalfEdgeId back = Brep::twin(h);
      // Parts on both sides of a null edge touch in a point only.
      if (brep_.point_of(brep_.from(h)) == brep_.point_of(brep_.from(back))) return;
      const FaceId beyond = brep_.face_of(back);
      switch (brep_.kind_of(beyond)) {
        case FaceKind::real:
          set_loaded(beyond, label);
          break;
        case FaceKind::null:
          break;
        case FaceKind::rest:
          spread_to(patch_.half_edge_in_solid[back.value()], label);
          break;
      }
    });
  }

  void spread_to(HalfEdgeId in_solid, std::uint8_t label) {
    const std::uint32_t s = solid().slot_of(in_solid);
    set_rest(s, slot(s).block->brep.face_of(solid().local(s, in_solid)), label);
  }

  void spread_face(std::uint32_t s, FaceId face) {
    const std::uint8_t label = rest_.of_member(s, face.value());
    for_each_in_face(slot(s).block->brep, face, [&](HalfEdgeId h) { spread_across(s, h, label); });
  }

  // All faces of a piece have its label; it ends at the block's borders.
  void spread_piece(std::uint32_t s, std::uint32_t piece) {
    const std::uint8_t label = rest_.of_member(s, piece);
    if (!slot(s).links) return;
    const BorderLinks& links = *slot(s).links;
    for (const BorderLinks::Neighbour& n : links.neighbours()) {
      if (n.own_piece != piece) continue;
      const std::uint32_t t = s + static_cast<std::uint32_t>(n.slots);
      if (!rest_.is_touched(t))
        set_member(t, n.piece, label);
      else
        for (const std::uint32_t border : links.borders(n))
          spread_across(s, Brep::half_edge(EdgeId(border)), label);
    }
  }

  void spread_across(std::uint32_t s, HalfEdgeId h, std::uint8_t label) {
    const auto [t, beyond] = solid().across(s, h);
    const FaceId face = slot(t).block->brep.face_of(beyond);
    if (rest_.is_loaded(t, face))
      set_loaded(brep_.face_of(Brep::twin(open_end(solid().half_edge(s, h)))), label);
    else
      set_rest(t, face, label);
  }

  // The loaded half-edge that stands for one of a face that is not loaded.
  HalfEdgeId open_end(HalfEdgeId in_solid) { return HalfEdgeId(open_ends_[in_solid.value()]); }

  void visit_untouched_shells() {
    std::vector<std::uint8_t> in_contact(brep_.vertex_count(), 0);
    for (const Contact& c : w_.contacts)
      if (c.on[s_].is_vertex()) in_contact[c.on[s_].vertex().value()] = 1;
    for (std::size_t f = 0; f < loaded_.size(); ++f) {
      if (loaded_[f] != unknown || !patch_.is_real(FaceId(f))) continue;
      if (patch_.unbounded) {  // nothing meets the plane: no part of it is inside the solid
        set_loaded(FaceId(f), label_(s_, Class::out));
        continue;
      }
      set_loaded(FaceId(f), label_of(free_point(FaceId(f), in_contact)));
      spread();
    }
    if (rest_.empty()) return;
    for (std::uint32_t s = 0; s < solid().slots().size(); ++s)
      for (std::uint32_t m = 0; m < rest_.count(s); ++m)
        if (rest_.of_member(s, m) == unknown) settle_by_ray(s, m);
  }

  void settle_by_ray(std::uint32_t s, std::uint32_t member) {
    const Brep& brep = slot(s).block->brep;
    std::uint32_t f = member;
    if (!rest_.is_touched(s)) {
      f = 0;
      while (slot(s).block->pieces().of_face[f] != member) ++f;
    }
    const HalfEdgeId h = brep.loop_half_edge[brep.outer_loop[f].value()];
    const PointId p = load_point(slot(s).block->geometry, brep.point_of(brep.from(h)), w_.geometry);
    w_.kernel->refresh();
    set_rest(s, FaceId(f), label_of(p));
    spread();
  }

  std::uint8_t label_of(PointId p) {
    return label_(s_, is_inside(w_, 1 - s_, p) ? Class::in : Class::out);
  }

  // A point of the shell of a face that is not on the other boundary.
  PointId free_point(FaceId start, const std::vector<std::uint8_t>& in_contact) {
    std::vector<FaceId> front{start};
    std::vector<EdgeId> edges;
    seen_[start.value()] = 1;
    PointId found;
    while (!front.empty() && !found.valid()) {
      const FaceId face = front.back();
      front.pop_back();
      for_each_in_face(brep_, face, [&](HalfEdgeId h) {
        const VertexId v = brep_.from(h);
        edges.push_back(Brep::edge_of(h));
        if (v.value() < in_contact.size() && !in_contact[v.value()]) found = brep_.point_of(v);
        const FaceId beyond = brep_.face_of(Brep::twin(h));
        if (brep_.kind_of(beyond) == FaceKind::rest) {
          const HalfEdgeId there = patch_.half_edge_in_solid[Brep::twin(h).value()];
          if (!found.valid()) found = point_beyond(there);
        } else if (patch_.is_real(beyond) && !seen_[beyond.value()]) {
          seen_[beyond.value()] = 1;
          front.push_back(beyond);
        }
      });
    }
    w_.kernel->refresh();
    if (!found.valid()) found = point_within(edges);
    if (!found.valid()) throw InternalError("a shell lies on the other boundary without a contact");
    return found;
  }

  // A corner, off the edge, of a face that is not loaded.
  PointId point_beyond(HalfEdgeId in_solid) {
    const std::uint32_t s = solid().slot_of(in_solid);
    const Brep& brep = slot(s).block->brep;
    const HalfEdgeId h = solid().local(s, in_solid);
    const VertexId across = slot(s).turned ? brep.to(brep.next_of(h)) : brep.from(brep.prev_of(h));
    return load_point(slot(s).block->geometry, brep.point_of(across), w_.geometry);
  }

  // A shell may touch the other boundary in all of its vertices. Its edges then lead away from it,
  // and a plane across one of them gives a point that is free.
  PointId point_within(std::vector<EdgeId>& edges) {
    std::vector<std::uint8_t> touched(brep_.edge_count(), 0);
    for (const Contact& c : w_.contacts)
      if (c.on[s_].is_edge()) touched[c.on[s_].edge().value()] = 1;
    std::erase_if(edges, [&](EdgeId e) { return touched[e.value()] != 0; });
    for (const EdgeId e : edges) {
      const HalfEdgeId h = Brep::half_edge(e);
      const PointId from = brep_.point_of(brep_.from(h)), to = brep_.point_of(brep_.to(h));
      for (int axis = 0; axis < 3; ++axis) {
        const PlaneId across = plane_between(from, to, axis);
        if (w_.tests().side(from, across) * w_.tests().side(to, across) != Sign::negative) continue;
        const Construction how = edge_plane_construction(w_, s_, h, across);
        const PointId made = add_constructed(w_.geometry, how, w_.tests().construct(how));
        w_.kernel->refresh();
        return made;
      }
    }
    return {};
  }

  PlaneId plane_between(PointId from, PointId to, int axis) {
    const Vec3 &p = w_.geometry.position(from), &q = w_.geometry.position(to);
    const double middle[3] = {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
    double normal[3] = {0, 0, 0};
    normal[axis] = 1;
    const PlaneId made =
        w_.geometry.add_plane(PlaneCoefficients{normal[0], normal[1], normal[2], -middle[axis]});
    w_.kernel->refresh();
    return made;
  }

  // A loaded face, or a face or piece of a slot.
  struct Pending {
    std::uint32_t slot, member;
  };
  static constexpr std::uint32_t loaded_slot = 0xFFFFFFFFu;

  Workspace& w_;
  int s_;
  const LabelOf& label_;
  const Patch& patch_;
  const Brep& brep_;
  std::vector<std::uint8_t>& loaded_;
  RestLabels& rest_;
  std::vector<std::uint8_t> seen_;  // per face: has it been looked at for a free point?
  IdMap open_ends_;
  std::vector<Pending> stack_;
};

}  // namespace

FaceLabels find_components(Workspace& w, const LabelOf& label_of) {
  FaceLabels labels;
  for (int s = 0; s < 2; ++s) Spreading(w, s, label_of, labels).run();
  return labels;
}

FaceLabels find_kept(Workspace& w, Operation operation) {
  return find_components(w, [operation](int solid, Class c) -> std::uint8_t {
    return kept(operation, solid, c) ? 1 : 0;
  });
}

}  // namespace sectile
