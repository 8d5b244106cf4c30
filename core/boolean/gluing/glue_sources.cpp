#include "boolean/gluing/glue_sources.h"

#include "boolean/collect.h"
#include "sectile/errors.h"

namespace sectile {

GlueSources::GlueSources(Workspace& w, Operation operation, const FaceLabels& kept,
                         const KeptBlocks& blocks)
    : w_(w), kept_(kept), blocks_(blocks) {
  sources_.reserve(2 + blocks.made_anew(Operand::a).size() + blocks.made_anew(Operand::b).size());
  for (const Operand s : both_operands) {
    const Brep& brep = w.patch[s].brep;
    sources_.push_back(
        {s, GlueSource::patch, &brep, reversed(operation, s), {}, {}, {}, {}, {}, {}});
    sources_.back().made.resize(brep.half_edge_count());
    partner_[s].resize(brep.half_edge_count());
  }
  for (const Operand s : both_operands) {
    const bool turned = reversed(operation, s);
    GlueSource& patch = sources_[static_cast<std::size_t>(s)];
    add_faces(patch, [&](FaceId f) { return kept.loaded[s][f] != 0; });
    if (turned) turn_planes(w.geometry, patch);
    if (!kept.rest[s].empty())
      source_of_slot_[s].resize(w.patch[s].solid->slots().size(), GlueSource::nowhere);
    for (const std::uint32_t slot : blocks.made_anew(s)) add_block(w.geometry, s, slot, turned);
  }
}

template <class Stays>
void GlueSources::add_faces(GlueSource& source, const Stays& stays) {
  source.place.resize(source.brep->face_count(), GlueSource::nowhere);
  const auto number = static_cast<std::uint32_t>(&source - sources_.data());
  for (const FaceId f : source.brep->faces()) {
    if (!stays(f)) continue;
    source.place[f] = static_cast<std::uint32_t>(faces_.size());
    faces_.push_back({number, f});
  }
}

void GlueSources::add_block(Geometry& geometry, Operand s, std::uint32_t slot, bool turned) {
  const Slot& of_solid = w_.patch[s].solid->slot(slot);
  const Block& block = *of_solid.block;
  source_of_slot_[s][slot] = static_cast<std::uint32_t>(sources_.size());
  sources_.push_back({s, slot, &block.brep(), of_solid.turned != turned, {}, {}, {}, {}, {}, {}});
  GlueSource& source = sources_.back();
  source.made.resize(block.brep().half_edge_count());
  const std::size_t before = faces_.size();
  add_faces(source, [&](FaceId f) { return kept_.rest[s].label(slot, f) == 1; });
  // Copying what goes costs less than asking what stays.
  const std::size_t all = block.brep().face_count(), stay = faces_.size() - before;
  if (2 * stay > all && !source.turned) {
    source.offset = append_geometry(block.geometry(), geometry);
  } else {
    source.geometry = std::make_unique<GeometryLoader>(block.geometry(), geometry, 2 * all);
    load_geometry(source);
  }
}

void GlueSources::load_geometry(GlueSource& source) {
  const Brep& brep = *source.brep;
  for (const FaceId f : brep.faces()) {
    if (source.place[f] == GlueSource::nowhere) continue;
    source.geometry->plane(brep.plane[f], source.turned);
    for_each_in_face(brep, f, [&](HalfEdgeId h) {
      source.geometry->point(brep.point_of(brep.from(h)));
      source.geometry->plane(brep.extra_plane(Brep::edge_of(h)));
    });
  }
}

void GlueSources::turn_planes(Geometry& geometry, GlueSource& source) {
  source.turned_planes.resize(geometry.planes.size());
  for (const FaceId f : source.brep->faces()) {
    if (source.place[f] == GlueSource::nowhere) continue;
    PlaneId& turned = source.turned_planes[source.brep->plane[f]];
    if (!turned.valid()) turned = add_turned_plane(geometry, source.brep->plane[f]);
  }
}

namespace {

// The half-edge of a face that stays which borders a side of a carrier.
HalfEdgeId side_half_edge(const HalfPlane& plane, const JoinedCuts& joined) {
  const CutSides& sides = joined.sides[plane.carrier];
  return plane.forward ? sides.forward : sides.backward;
}

}  // namespace

void GlueSources::pair_sides(const Neighborhoods& n, const Wedges& wedges,
                             const JoinedCuts& joined) {
  for_each(w_, wedges.pairs.size(), 8192, [&](std::size_t i) {
    const WedgePair& pair = wedges.pairs[i];
    const HalfPlane &p = n.half_planes[pair.first], &q = n.half_planes[pair.second];
    if (!n.carriers[p.carrier].cut) return;  // both sides of one face or edge
    const HalfEdgeId g = side_half_edge(p, joined), h = side_half_edge(q, joined);
    partner_[p.operand][g] = {h, q.operand};
    partner_[q.operand][h] = {g, p.operand};
  });
  for (const HalfPlaneId id : wedges.continued) {
    const HalfPlane& h = n.half_planes[id];
    GlueSource& patch = sources_[static_cast<std::size_t>(h.operand)];
    if (patch.continued.empty()) patch.continued.resize(patch.brep->half_edge_count());
    patch.continued[side_half_edge(h, joined)] = 1;
  }
}

GlueSources::Mate GlueSources::mate(const SourceHalfEdge& e) const {
  const GlueSource& from = sources_[e.source];
  const Patch& patch = w_.patch[from.operand];
  if (from.slot != GlueSource::patch) {
    const auto beyond = patch.solid->across(from.slot, e.h);
    return in_slot(from.operand, beyond.slot, beyond.local);
  }
  if (const Partner& partner = partner_[from.operand][e.h]; partner.h.valid())
    return {Mate::Kind::glued, true, {static_cast<std::uint32_t>(partner.operand), partner.h}, {}};
  const HalfEdgeId back = Brep::twin(e.h);
  const FaceKind beyond = patch.brep.kind_of(patch.brep.face_of(back));
  if (beyond == FaceKind::null) throw InternalError("a kept side of a cut has no partner");
  if (beyond == FaceKind::real) return {Mate::Kind::glued, false, {e.source, back}, {}};
  const HalfEdgeId in_solid = patch.half_edge_in_solid[back];
  const std::uint32_t slot = patch.solid->slot_of(in_solid);
  return in_slot(from.operand, slot, patch.solid->local(slot, in_solid));
}

GlueSources::Mate GlueSources::in_slot(Operand s, std::uint32_t slot, HalfEdgeId h) const {
  if (blocks_.is_shared(s, slot, h))
    return {Mate::Kind::shared, false, {}, blocks_.border_edge(s, slot, h)};
  const Brep& brep = w_.patch[s].solid->slot(slot).block->brep();
  if (kept_.rest[s].is_loaded(slot, brep.face_of(h))) return {Mate::Kind::earlier, false, {}, {}};
  const std::uint32_t source = source_of_slot_[s][slot];
  if (source == GlueSource::nowhere) throw InternalError("an edge of the result has only one face");
  return {Mate::Kind::glued, false, {source, h}, {}};
}

}  // namespace sectile
