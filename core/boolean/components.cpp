#include "boolean/components.h"

#include "boolean/line.h"
#include "boolean/ray.h"
#include "boolean/tables.h"
#include "geometry/probe.h"
#include "search/id_map.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr std::uint8_t nothing = 0, unknown = 255;

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
    if (!patch_.whole) find_rest();
  }

  void run() {
    seed_from_segments();
    spread();
    visit_untouched_shells();
    for (std::size_t f = 0; f < loaded_.size(); ++f)
      if (!patch_.is_real(FaceId(f))) loaded_[f] = nothing;
    for (std::uint8_t& label : rest_)
      if (label == unknown) label = nothing;  // the loaded ones
  }

 private:
  const Brep& solid() const { return patch_.solid->brep(); }

  void find_rest() {
    rest_.assign(solid().face_count(), unknown);
    is_loaded_.assign(solid().face_count(), 0);
    for (const FaceId f : patch_.face_in_solid) is_loaded_[f.value()] = 1;
    for (std::size_t i = 0; i < patch_.half_edge_in_solid.size(); ++i)
      if (const HalfEdgeId h = patch_.half_edge_in_solid[i]; h.valid())
        open_ends_[h.value()] = static_cast<std::uint32_t>(i);
  }

  void set(std::vector<std::uint8_t>& labels, std::uint32_t face, std::uint8_t label, bool loaded) {
    std::uint8_t& now = labels[face];
    if (now == label) return;
    if (now != unknown)
      throw InternalError("a piece of a boundary is kept by one cut, not by another");
    now = label;
    stack_.push_back({face, loaded});
  }
  void set_loaded(FaceId f, std::uint8_t label) { set(loaded_, f.value(), label, true); }
  void set_rest(FaceId f, std::uint8_t label) { set(rest_, f.value(), label, false); }

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
      const auto [face, loaded] = stack_.back();
      stack_.pop_back();
      if (loaded)
        spread_loaded(FaceId(face));
      else
        spread_rest(FaceId(face));
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
          set_rest(solid().face_of(patch_.half_edge_in_solid[back.value()]), label);
          break;
      }
    });
  }

  void spread_rest(FaceId face) {
    const std::uint8_t label = rest_[face.value()];
    for_each_in_face(solid(), face, [&](HalfEdgeId h) {
      const FaceId beyond = solid().face_of(Brep::twin(h));
      if (!is_loaded_[beyond.value()])
        set_rest(beyond, label);
      else
        set_loaded(brep_.face_of(Brep::twin(HalfEdgeId(open_ends_[h.value()]))), label);
    });
  }

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
    for (std::size_t f = 0; f < rest_.size(); ++f) {
      if (rest_[f] != unknown || is_loaded_[f]) continue;
      const HalfEdgeId h = solid().loop_half_edge[solid().outer_loop[f].value()];
      const PointId p =
          load_point(patch_.solid->geometry(), solid().point_of(solid().from(h)), w_.geometry);
      w_.kernel->refresh();
      set_rest(FaceId(f), label_of(p));
      spread();
    }
  }

  std::uint8_t label_of(PointId p) {
    return label_(s_, is_inside(w_, 1 - s_, p) ? Class::in : Class::out);
  }

  // A point of the shell of a face that is not on the other boundary.
  PointId free_point(FaceId start, const std::vector<std::uint8_t>& in_contact) {
    std::vector<std::uint8_t> seen(brep_.face_count(), 0);
    std::vector<FaceId> front{start};
    std::vector<EdgeId> edges;
    seen[start.value()] = 1;
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
          const HalfEdgeId across = solid().prev_of(there);
          if (!found.valid())
            found = load_point(patch_.solid->geometry(), solid().point_of(solid().from(across)),
                               w_.geometry);
        } else if (patch_.is_real(beyond) && !seen[beyond.value()]) {
          seen[beyond.value()] = 1;
          front.push_back(beyond);
        }
      });
    }
    w_.kernel->refresh();
    if (!found.valid()) found = point_within(edges);
    if (!found.valid()) throw InternalError("a shell lies on the other boundary without a contact");
    return found;
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

  struct Pending {
    std::uint32_t face;
    bool loaded;
  };

  Workspace& w_;
  int s_;
  const LabelOf& label_;
  const Patch& patch_;
  const Brep& brep_;
  std::vector<std::uint8_t>& loaded_;
  std::vector<std::uint8_t>& rest_;
  std::vector<std::uint8_t> is_loaded_;
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
