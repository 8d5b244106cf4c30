#include "boolean/gluing/kept_blocks.h"

#include <algorithm>

#include "boolean/side_by_side.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

std::vector<FaceId> those_that_stay(const RestLabels& rest, std::uint32_t slot,
                                    const Block& block) {
  std::vector<FaceId> faces;
  for (const FaceId f : block.brep().faces())
    if (rest.label(slot, f) == 1) faces.push_back(f);
  return faces;
}

bool is_small(const Slot& slot) {
  return slot.faces < few_faces && slot.half_edges < 2 * corners_of_a_large_face;
}

}  // namespace

KeptBlocks::KeptBlocks(const Workspace& w, Operation operation, const FaceLabels& kept)
    : w_(w), kept_(kept) {
  std::vector<Slot>& slots = shared.slots;
  for (const Operand s : both_operands) {
    first_slot_[s] = static_cast<std::uint32_t>(slots.size());
    if (kept.rest[s].empty()) continue;
    const SolidData& solid = *w.patch[s].solid;
    slots.resize(slots.size() + solid.slots().size());
    trimmed_[s].emplace(solid);
  }
  for_both_operands(slots.size(), [&](Operand s) {
    if (trimmed_[s]) share(s, reversed(operation, s));
  });
  for (const Operand s : both_operands)
    if (trimmed_[s]) trimmed_[s]->link(shared, first_slot_[s]);
}

void KeptBlocks::share(Operand s, bool turned) {
  const RestLabels& rest = kept_.rest[s];
  const SolidData& solid = *w_.patch[s].solid;
  const std::span<Slot> slots = std::span(shared.slots).subspan(first_slot_[s]);
  std::vector<TrimmedBlocks::Rest> rests;
  for (std::uint32_t t = 0; t < solid.slots().size(); ++t) {
    const Slot& slot = solid.slot(t);
    if (slot.empty() || !rest.has(t, 1)) continue;
    if (!rest.is_touched(t) && rest.has_only(t, 1) && !is_small(slot)) {
      slots[t] = slot;
      slots[t].turned = slot.turned != turned;
    } else if (std::vector<FaceId> faces = those_that_stay(rest, t, *slot.block);
               solid.slots().size() > 1 && faces.size() >= few_faces) {
      rests.push_back({t, std::move(faces)});
    } else {
      made_anew_[s].push_back(t);
    }
  }
  TrimmedBlocks& trimmed = *trimmed_[s];
  trimmed.trim(std::move(rests));
  for (const std::uint32_t t : trimmed.slots())
    slots[t] = {trimmed[t]->block(), nullptr, solid.slot(t).turned != turned};
  for (const FarLoops& far : w_.patch[s].far_loops) keep_loops(s, far, turned);
}

void KeptBlocks::keep_loops(Operand s, const FarLoops& far, bool turned) {
  std::vector<LoopId> loops;
  for (const LoopId l : far.loops)
    if (kept_.loaded[s][far.part[l]] != 0) loops.push_back(l);
  if (loops.empty()) return;
  std::ranges::stable_sort(loops, {}, [&](LoopId l) { return far.part[l]; });
  const std::uint32_t slot = first_slot_[s] + far.slot;
  const Slot& old = w_.patch[s].solid->slot(far.slot);
  shared.slots[slot] = {old.block, old.links, old.turned != turned};
  std::vector<KeptLoops>& kept = kept_loops_[s];
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const FaceId part = far.part[loops[i]];
    if (i == 0 || part != far.part[loops[i - 1]]) kept.push_back({part, slot, {}});
    kept.back().loops.push_back(loops[i]);
  }
}

bool KeptBlocks::is_shared(Operand s, std::uint32_t slot, HalfEdgeId h) const {
  if (shared.slots[first_slot_[s] + slot].empty()) return false;
  const FaceId face = w_.patch[s].solid->slot(slot).block->brep().face_of(h);
  if (!kept_.rest[s].is_loaded(slot, face)) return true;
  const FaceId part = w_.patch[s].part_of_far(slot, h);
  return part.valid() && kept_.loaded[s][part] != 0;
}

BorderEdge KeptBlocks::border_edge(Operand s, std::uint32_t slot, HalfEdgeId h) const {
  BorderEdge edge = trimmed_[s]->border_edge(slot, h);
  if (edge.border == TrimmedBlock::none)
    throw InternalError("an edge of the result has only one face");
  edge.slot += first_slot_[s];
  return edge;
}

}  // namespace sectile
