#include "boolean/gluing.h"

#include <optional>

#include "boolean/geometry_copy.h"
#include "boolean/tables.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// A half-edge of one of the sources: a loaded patch, or what was not loaded of an operand.
struct SourceHalfEdge {
  std::uint8_t solid;
  bool loaded;
  HalfEdgeId h;
};

class Assembly {
 public:
  Assembly(const Workspace& w, Operation operation, std::span<const WedgePair> wedges,
           const FaceLabels& kept)
      : w_(w),
        operation_(operation),
        kept_(kept),
        glued_{std::make_shared<SolidData>(), {}},
        brep_(glued_.data->brep()),
        local_(w.geometry, glued_.data->geometry()) {
    for (int s = 0; s < 2; ++s) {
      const Patch& patch = w.patch[s];
      partner_[s].resize(patch.brep.half_edge_count(), {0, true, HalfEdgeId()});
      new_loaded_[s].resize(patch.brep.half_edge_count());
      if (kept.rest[s].empty()) continue;
      new_rest_[s].resize(patch.solid->brep().half_edge_count());
      rest_[s].emplace(patch.solid->geometry(), glued_.data->geometry());
    }
    for (const WedgePair& pair : wedges) set_partners(pair);
  }

  Glued run() {
    reserve();
    for (int s = 0; s < 2; ++s) {
      for (std::size_t f = 0; f < kept_.loaded[s].size(); ++f)
        if (kept_.loaded[s][f]) add_face(s, true, FaceId(f));
      for (std::size_t f = 0; f < kept_.rest[s].size(); ++f)
        if (kept_.rest[s][f]) add_face(s, false, FaceId(f));
    }
    fix_edge_planes();
    make_vertices();
    return std::move(glued_);
  }

 private:
  // For each corner of a kept face there will be a half-edge.
  void reserve() {
    std::size_t half_edges = 0, faces = 0;
    for (int s = 0; s < 2; ++s)
      for (const bool loaded : {true, false}) {
        const auto& kept = loaded ? kept_.loaded[s] : kept_.rest[s];
        if (kept.empty()) continue;
        const Brep& from = source(s, loaded);
        for (std::size_t h = 0; h < from.half_edge_count(); ++h)
          half_edges += kept[from.face_of(HalfEdgeId(h)).value()] != 0;
        for (const std::uint8_t label : kept) faces += label != 0;
      }
    const std::size_t edges = half_edges / 2;
    brep_.reserve(edges, faces, edges > faces ? edges - faces + 2 : 2);
    start_.reserve(half_edges);
  }

  const Brep& source(int s, bool loaded) const {
    return loaded ? w_.patch[s].brep : w_.patch[s].solid->brep();
  }

  // The half-edge of a kept face that borders a side of a carrier.
  HalfEdgeId side_half_edge(const HalfPlane& plane) const {
    const Carrier& c = w_.carriers[plane.carrier];
    return plane.forward ? c.forward : c.backward;
  }

  void set_partners(const WedgePair& pair) {
    const HalfPlane &p = w_.half_planes[pair.first], &q = w_.half_planes[pair.second];
    if (!w_.carriers[p.carrier].cut) return;  // both sides of one face or edge
    const HalfEdgeId g = side_half_edge(p), h = side_half_edge(q);
    partner_[p.solid][g.value()] = {q.solid, true, h};
    partner_[q.solid][h.value()] = {p.solid, true, g};
  }

  HalfEdgeId& made(const SourceHalfEdge& e) {
    return (e.loaded ? new_loaded_ : new_rest_)[e.solid][e.h.value()];
  }

  SourceHalfEdge mate(const SourceHalfEdge& e, bool& seam) const {
    const HalfEdgeId back = Brep::twin(e.h);
    if (!e.loaded) return {e.solid, false, back};
    const SourceHalfEdge& partner = partner_[e.solid][e.h.value()];
    if (partner.h.valid()) {
      seam = true;
      return partner;
    }
    const Patch& patch = w_.patch[e.solid];
    const FaceKind beyond = patch.brep.kind_of(patch.brep.face_of(back));
    if (beyond == FaceKind::null) throw InternalError("a kept side of a cut has no partner");
    if (beyond == FaceKind::real) return {e.solid, true, back};
    return {e.solid, false, patch.half_edge_in_solid[back.value()]};
  }

  HalfEdgeId make(const SourceHalfEdge& e) {
    HalfEdgeId& id = made(e);
    if (id.valid()) return id;
    id = HalfEdgeId(brep_.half_edge_count());
    bool seam = false;
    made(mate(e, seam)) = Brep::twin(id);
    const std::size_t count = brep_.half_edge_count() + 2;
    brep_.origin.resize(count);
    brep_.next.resize(count);
    brep_.prev.resize(count);
    brep_.loop.resize(count);
    if (seam) glued_.seams.push_back(Brep::edge_of(id));
    keep_edge_plane(e, Brep::edge_of(id));
    return id;
  }

  void keep_edge_plane(const SourceHalfEdge& e, EdgeId made_edge) {
    const PlaneId plane = source(e.solid, e.loaded).extra_plane(Brep::edge_of(e.h));
    if (!plane.valid()) return;
    set_edge_plane(made_edge, copy_of(e.solid, e.loaded).plane(plane));
  }

  void set_edge_plane(EdgeId e, PlaneId plane) {
    if (brep_.edge_plane.size() <= e.value()) brep_.edge_plane.resize(e.value() + 1);
    brep_.edge_plane[e.value()] = plane;
  }

  // Seams between coplanar faces need a plane that pins them down.
  void fix_edge_planes() {
    for (int s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < partner_[s].size(); ++i) {
        const SourceHalfEdge& other = partner_[s][i];
        const HalfEdgeId id = new_loaded_[s][i], h{i};
        if (!other.h.valid() || !id.valid() || (id.value() & 1u)) continue;
        const PlaneId p = w_.patch[s].brep.plane_of(h);
        const PlaneId q = w_.patch[other.solid].brep.plane_of(other.h);
        if (w_.tests().parallel(p, q))
          set_edge_plane(Brep::edge_of(id), local_.plane(w_.patch[s].side(h)));
        else if (!brep_.edge_plane.empty() && Brep::edge_of(id).value() < brep_.edge_plane.size())
          brep_.edge_plane[Brep::edge_of(id).value()] = PlaneId();
      }
    if (!brep_.edge_plane.empty()) brep_.edge_plane.resize(brep_.edge_count());
  }

  GeometryCopy& copy_of(int s, bool loaded) { return loaded ? local_ : *rest_[s]; }

  static bool is_null_edge(const Brep& brep, HalfEdgeId h) {
    return brep.point_of(brep.from(h)) == brep.point_of(brep.to(h));
  }

  void add_face(int s, bool loaded, FaceId face) {
    const Brep& from = source(s, loaded);
    const bool turn = reversed(operation_, s);
    const FaceId here(brep_.face_count());
    const PlaneId plane = from.plane[face.value()];
    brep_.plane.push_back(turn ? copy_of(s, loaded).turned(plane)
                               : copy_of(s, loaded).plane(plane));
    brep_.source.push_back(from.source[face.value()]);
    brep_.outer_loop.push_back(LoopId());
    LoopId last;
    for (LoopId l = from.outer_loop[face.value()]; l.valid(); l = from.next_loop[l.value()]) {
      chain_.clear();
      for_each_in_loop(from, l, [&](HalfEdgeId h) {
        if (loaded && is_null_edge(from, h)) return;
        chain_.push_back(h);
      });
      if (!chain_.empty()) add_loop(s, loaded, here, last, turn);
    }
  }

  void add_loop(int s, bool loaded, FaceId face, LoopId& last, bool turn) {
    const Brep& from = source(s, loaded);
    const LoopId loop(brep_.loop_count());
    brep_.loop_face.push_back(face);
    brep_.next_loop.push_back(LoopId());
    (last.valid() ? brep_.next_loop[last.value()] : brep_.outer_loop[face.value()]) = loop;
    last = loop;
    GeometryCopy& copy = copy_of(s, loaded);
    HalfEdgeId before, first;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      const HalfEdgeId h = turn ? chain_[chain_.size() - 1 - i] : chain_[i];
      const HalfEdgeId id = make({static_cast<std::uint8_t>(s), loaded, h});
      start_.resize(brep_.half_edge_count());
      start_[id.value()] = copy.point(from.point_of(turn ? from.to(h) : from.from(h)));
      brep_.loop[id.value()] = loop;
      if (before.valid()) {
        brep_.next[before.value()] = id;
        brep_.prev[id.value()] = before;
      } else {
        first = id;
      }
      before = id;
    }
    brep_.next[before.value()] = first;
    brep_.prev[first.value()] = before;
    brep_.loop_half_edge.push_back(first);
  }

  void make_vertices() {
    for (std::size_t i = 0; i < brep_.half_edge_count(); ++i) {
      if (!brep_.loop[i].valid()) throw InternalError("an edge of the result has only one face");
      if (brep_.origin[i].valid()) continue;
      const HalfEdgeId first{i};
      const VertexId v(brep_.vertex_count());
      brep_.point.push_back(start_[i]);
      brep_.vertex_half_edge.push_back(first);
      HalfEdgeId h = first;
      do {
        brep_.origin[h.value()] = v;
        h = brep_.around(h);
      } while (h != first);
    }
  }

  const Workspace& w_;
  Operation operation_;
  const FaceLabels& kept_;
  Glued glued_;
  Brep& brep_;
  GeometryCopy local_;
  std::optional<GeometryCopy> rest_[2];
  std::vector<SourceHalfEdge> partner_[2];
  std::vector<HalfEdgeId> new_loaded_[2], new_rest_[2];
  std::vector<PointId> start_;  // per half-edge of the result
  std::vector<HalfEdgeId> chain_;
};

}  // namespace

Glued glue(const Workspace& w, Operation operation, std::span<const WedgePair> wedges,
           const FaceLabels& kept) {
  return Assembly(w, operation, wedges, kept).run();
}

}  // namespace sectile
