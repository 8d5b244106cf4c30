#include "boolean/gluing/gluing.h"

#include <memory>
#include <optional>

#include "boolean/side_by_side.h"
#include "sectile/errors.h"
#include "storage/geometry_loader.h"
#include "storage/trimmed_blocks.h"
#include "topology/open_ends.h"
#include "topology/vertex_cycles.h"

namespace sectile {
namespace {

constexpr std::uint32_t loaded = 0xFFFFFFFFu;  // instead of a slot

// A half-edge of one of the sources: of a loaded patch, or of a block.
struct SourceHalfEdge {
  Operand operand;
  std::uint32_t slot;
  HalfEdgeId h;
};

class Gluer {
 public:
  Gluer(const Workspace& w, Operation operation, const FaceLabels& kept)
      : w_(w),
        operation_(operation),
        kept_(kept),
        brep_(glued_.brep),
        local_(w.geometry, glued_.geometry, w.geometry.positions.size()) {
    for (const Operand s : both_operands) {
      partner_[s].resize(w.patch[s].brep.half_edge_count(), {Operand::a, loaded, HalfEdgeId()});
      made_loaded_[s].resize(w.patch[s].brep.half_edge_count());
    }
    share_blocks();
  }

  void pair_sides(const Neighborhoods& n, std::span<const WedgePair> wedges,
                  const JoinedCuts& joined) {
    for (const WedgePair& pair : wedges) {
      const HalfPlane &p = n.half_planes[pair.first], &q = n.half_planes[pair.second];
      if (!n.carriers[p.carrier].cut) continue;  // both sides of one face or edge
      const HalfEdgeId g = side_half_edge(p, joined), h = side_half_edge(q, joined);
      partner_[p.operand][g] = {q.operand, loaded, h};
      partner_[q.operand][h] = {p.operand, loaded, g};
    }
  }

  Glued run() {
    reserve();
    for_each_kept_face([&](const Source& from, FaceId f) { add_outside_edges(from, f); });
    for_each_kept_face([&](const Source& from, FaceId f) { add_face(from, f); });
    fix_edge_planes();
    close_ends();
    check_faces();
    make_vertices(brep_, start_);
    return std::move(glued_);
  }

 private:
  // What is made anew of a block: the faces that stay and are not loaded.
  struct Copied {
    Copied(const Block& block, Geometry& to)
        : geometry(block.geometry, to, 2 * block.brep.face_count()),
          made(block.brep.half_edge_count()) {}
    GeometryLoader geometry;
    Table<HalfEdgeId, HalfEdgeId> made;  // of the block
  };

  // Faces of one kind, and how they are read.
  struct Source {
    Operand operand;
    std::uint32_t slot;
    const Brep& brep;
    GeometryLoader& geometry;
    bool turned;
  };

  bool turns(Operand s) const { return reversed(operation_, s); }

  void share_blocks() {
    std::vector<Slot>& slots = glued_.shared.slots;
    for (const Operand s : both_operands) {
      first_slot_[s] = static_cast<std::uint32_t>(slots.size());
      if (kept_.rest[s].empty()) continue;
      const SolidData& solid = *w_.patch[s].solid;
      copied_[s].resize(solid.slots().size());
      slots.resize(slots.size() + solid.slots().size());
      trimmed_[s].emplace(solid);
    }
    for_both_operands(slots.size(), [&](Operand s) {
      if (trimmed_[s]) share_blocks(s);
    });
    for (const Operand s : both_operands)
      if (trimmed_[s]) trimmed_[s]->link(glued_.shared, first_slot_[s]);
  }

  // Blocks stay, are trimmed or, if they have few faces, made anew with what is glued.
  void share_blocks(Operand s) {
    const RestLabels& rest = kept_.rest[s];
    const SolidData& solid = *w_.patch[s].solid;
    const std::span<Slot> slots = std::span(glued_.shared.slots).subspan(first_slot_[s]);
    std::vector<TrimmedBlocks::Rest> rests;
    for (std::uint32_t t = 0; t < solid.slots().size(); ++t) {
      const Slot& slot = solid.slot(t);
      if (slot.empty() || !rest.has(t, 1)) continue;
      if (!rest.is_touched(t) && rest.has_only(t, 1) && slot.faces >= few_faces) {
        slots[t] = slot;
        slots[t].turned = slot.turned != turns(s);
      } else if (std::vector<FaceId> faces = those_that_stay(rest, t, *slot.block);
                 solid.slots().size() > 1 && faces.size() >= few_faces) {
        rests.push_back({t, std::move(faces)});
      } else {
        copied_[s][t] = std::make_unique<Copied>(*slot.block, glued_.geometry);
      }
    }
    TrimmedBlocks& trimmed = *trimmed_[s];
    trimmed.trim(std::move(rests));
    for (const std::uint32_t t : trimmed.slots())
      slots[t] = {trimmed[t]->block(), nullptr, solid.slot(t).turned != turns(s)};
  }

  static std::vector<FaceId> those_that_stay(const RestLabels& rest, std::uint32_t slot,
                                             const Block& block) {
    std::vector<FaceId> faces;
    for (const FaceId f : block.brep.faces())
      if (rest.label(slot, f) == 1) faces.push_back(f);
    return faces;
  }

  template <class Visit>
  void for_each_kept_face(const Visit& visit) {
    for (const Operand s : both_operands) {
      const Source patch{s, loaded, w_.patch[s].brep, local_, turns(s)};
      for (const FaceId f : kept_.loaded[s].ids())
        if (kept_.loaded[s][f]) visit(patch, f);
      for (std::uint32_t t = 0; t < copied_[s].size(); ++t) {
        if (!copied_[s][t]) continue;
        const Slot& slot = w_.patch[s].solid->slot(t);
        const Source block{s, t, slot.block->brep, copied_[s][t]->geometry,
                           slot.turned != turns(s)};
        for (std::size_t f = 0; f < block.brep.face_count(); ++f)
          if (kept_.rest[s].label(t, FaceId(f)) == 1) visit(block, FaceId(f));
      }
    }
  }

  // For each corner of a face there will be a half-edge.
  void reserve() {
    std::size_t half_edges = 0, faces = 0;
    for_each_kept_face([&](const Source& from, FaceId f) {
      ++faces;
      for_each_in_face(from.brep, f, [&](HalfEdgeId) { ++half_edges; });
    });
    const std::size_t edges = half_edges / 2;
    brep_.reserve(edges, faces, edges > faces ? edges - faces + 2 : 2);
    start_.reserve(half_edges);
  }

  // The half-edge of a kept face that borders a side of a carrier.
  static HalfEdgeId side_half_edge(const HalfPlane& plane, const JoinedCuts& joined) {
    const CutSides& sides = joined.sides[plane.carrier];
    return plane.forward ? sides.forward : sides.backward;
  }

  HalfEdgeId& made(const SourceHalfEdge& e) {
    if (e.slot == loaded) return made_loaded_[e.operand][e.h];
    if (!copied_[e.operand][e.slot]) throw InternalError("an edge of the result has only one face");
    return copied_[e.operand][e.slot]->made[e.h];
  }

  SourceHalfEdge in_slot(Operand s, HalfEdgeId in_solid) const {
    const SolidData& solid = *w_.patch[s].solid;
    const std::uint32_t slot = solid.slot_of(in_solid);
    return {s, slot, solid.local(slot, in_solid)};
  }

  SourceHalfEdge mate(const SourceHalfEdge& e, bool& seam) const {
    const Patch& patch = w_.patch[e.operand];
    if (e.slot != loaded) {
      const auto beyond = patch.solid->across(e.slot, e.h);
      return {e.operand, beyond.slot, beyond.local};
    }
    const SourceHalfEdge& partner = partner_[e.operand][e.h];
    if (partner.h.valid()) {
      seam = true;
      return partner;
    }
    const HalfEdgeId back = Brep::twin(e.h);
    const FaceKind beyond = patch.brep.kind_of(patch.brep.face_of(back));
    if (beyond == FaceKind::null) throw InternalError("a kept side of a cut has no partner");
    if (beyond == FaceKind::real) return {e.operand, loaded, back};
    return in_slot(e.operand, patch.half_edge_in_solid[back]);
  }

  bool is_shared(const SourceHalfEdge& e) const {
    if (e.slot == loaded || glued_.shared.slots[first_slot_[e.operand] + e.slot].empty())
      return false;
    const FaceId face = w_.patch[e.operand].solid->slot(e.slot).block->brep.face_of(e.h);
    return !kept_.rest[e.operand].is_loaded(e.slot, face);
  }

  BorderEdge border_edge(const SourceHalfEdge& e) const {
    BorderEdge edge = trimmed_[e.operand]->border_edge(e.slot, e.h);
    if (edge.border == TrimmedBlock::none)
      throw InternalError("an edge of the result has only one face");
    edge.slot += first_slot_[e.operand];
    return edge;
  }

  HalfEdgeId add_edge(const SourceHalfEdge& e) {
    const HalfEdgeId id = made(e) = HalfEdgeId(brep_.half_edge_count());
    brep_.resize_half_edges(brep_.half_edge_count() + 2);
    start_.resize(brep_.half_edge_count());
    return id;
  }

  // Edges to shared blocks come first.
  void add_outside_edges(const Source& from, FaceId face) {
    if (glued_.shared.slots.empty()) return;
    for_each_in_face(from.brep, face, [&](HalfEdgeId h) {
      const SourceHalfEdge e{from.operand, from.slot, h};
      bool seam = false;
      if (is_null_edge(from, h)) return;
      const SourceHalfEdge other = mate(e, seam);
      if (!is_shared(other)) return;
      const HalfEdgeId id = add_edge(e);
      glued_.outside.push_back(border_edge(other));
      keep_edge_plane(from, h, Brep::edge_of(id));
    });
  }

  HalfEdgeId make(const Source& from, HalfEdgeId h) {
    const SourceHalfEdge e{from.operand, from.slot, h};
    if (const HalfEdgeId known = made(e); known.valid()) return known;
    const HalfEdgeId id = add_edge(e);
    bool seam = false;
    made(mate(e, seam)) = Brep::twin(id);
    if (seam) glued_.seams.push_back(Brep::edge_of(id));
    keep_edge_plane(from, h, Brep::edge_of(id));
    return id;
  }

  void keep_edge_plane(const Source& from, HalfEdgeId h, EdgeId made_edge) {
    const PlaneId plane = from.brep.extra_plane(Brep::edge_of(h));
    if (plane.valid()) set_edge_plane(made_edge, from.geometry.plane(plane));
  }

  void set_edge_plane(EdgeId e, PlaneId plane) {
    if (brep_.edge_plane.size() <= e.value()) brep_.edge_plane.resize(e.value() + 1);
    brep_.edge_plane[e] = plane;
  }

  // Seams between coplanar faces need a plane that pins them down.
  void fix_edge_planes() {
    for (const Operand s : both_operands)
      for (const HalfEdgeId h : partner_[s].ids()) {
        const SourceHalfEdge& other = partner_[s][h];
        const HalfEdgeId id = made_loaded_[s][h];
        if (!other.h.valid() || !id.valid() || id != Brep::half_edge(Brep::edge_of(id))) continue;
        const PlaneId p = w_.patch[s].brep.plane_of(h);
        const PlaneId q = w_.patch[other.operand].brep.plane_of(other.h);
        if (w_.tests().parallel(p, q))
          set_edge_plane(Brep::edge_of(id), local_.plane(w_.patch[s].side(h)));
        else if (!brep_.edge_plane.empty() && Brep::edge_of(id).value() < brep_.edge_plane.size())
          brep_.edge_plane[Brep::edge_of(id)] = PlaneId();
      }
    if (!brep_.edge_plane.empty()) brep_.edge_plane.resize(brep_.edge_count());
  }

  static bool is_null_edge(const Source& from, HalfEdgeId h) {
    return from.slot == loaded &&
           from.brep.point_of(from.brep.from(h)) == from.brep.point_of(from.brep.to(h));
  }

  void add_face(const Source& from, FaceId face) {
    const FaceId here = brep_.add_face(from.geometry.plane(from.brep.plane[face], from.turned),
                                       from.brep.source[face]);
    LoopId last;
    for (LoopId l = from.brep.outer_loop[face]; l.valid(); l = from.brep.next_loop[l]) {
      chain_.clear();
      for_each_in_loop(from.brep, l, [&](HalfEdgeId h) {
        if (!is_null_edge(from, h)) chain_.push_back(h);
      });
      if (!chain_.empty()) add_loop(from, here, last);
    }
  }

  LoopId add_loop(FaceId face, LoopId& last) {
    const LoopId loop = brep_.add_loop(face);
    (last.valid() ? brep_.next_loop[last] : brep_.outer_loop[face]) = loop;
    return last = loop;
  }

  void add_loop(const Source& from, FaceId face, LoopId& last) {
    const LoopId loop = add_loop(face, last);
    HalfEdgeId before, first;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      const HalfEdgeId h = from.turned ? chain_[chain_.size() - 1 - i] : chain_[i];
      const HalfEdgeId id = make(from, h);
      start_[id.value()] = from.geometry.point(
          from.brep.point_of(from.turned ? from.brep.to(h) : from.brep.from(h)));
      brep_.loop[id] = loop;
      if (before.valid()) {
        brep_.next[before] = id;
        brep_.prev[id] = before;
      } else {
        first = id;
      }
      before = id;
    }
    brep_.next[before] = first;
    brep_.prev[first] = before;
    brep_.loop_half_edge[loop] = first;
  }

  // As in a patch: what is shared is stood for by faces of kind `rest`.
  void close_ends() {
    if (glued_.outside.empty()) return;
    brep_.kind.assign(brep_.face_count(), FaceKind::real);
    std::vector<HalfEdgeId> open;
    for (const EdgeId e : IdRange<EdgeId>(EdgeId(0), EdgeId(glued_.outside.size()))) {
      open.push_back(Brep::half_edge(e, 1));
      start_[open.back().value()] = start_[brep_.next_of(Brep::half_edge(e)).value()];
    }
    close_open_ends(brep_, open);
  }

  void check_faces() const {
    for (const LoopId l : brep_.loop)
      if (!l.valid()) throw InternalError("an edge of the result has only one face");
  }

  const Workspace& w_;
  Operation operation_;
  const FaceLabels& kept_;
  Glued glued_;
  Brep& brep_;
  GeometryLoader local_;  // of the workspace
  PerOperand<std::uint32_t> first_slot_;
  PerOperand<std::optional<TrimmedBlocks>> trimmed_;
  PerOperand<std::vector<std::unique_ptr<Copied>>> copied_;  // per slot
  PerOperand<Table<HalfEdgeId, SourceHalfEdge>> partner_;
  PerOperand<Table<HalfEdgeId, HalfEdgeId>> made_loaded_;
  std::vector<PointId> start_;  // per half-edge of the result
  std::vector<HalfEdgeId> chain_;
};

}  // namespace

Glued glue(const Workspace& w, Operation operation, const Neighborhoods& neighborhoods,
           std::span<const WedgePair> wedges, const JoinedCuts& joined, const FaceLabels& kept) {
  Gluer gluer(w, operation, kept);
  gluer.pair_sides(neighborhoods, wedges, joined);
  return gluer.run();
}

}  // namespace sectile
