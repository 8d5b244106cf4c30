#include "boolean/gluing/kept_blocks.h"

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
    if (!rest.is_touched(t) && rest.has_only(t, 1) && slot.faces >= few_faces) {
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
}

bool KeptBlocks::is_shared(Operand s, std::uint32_t slot, HalfEdgeId h) const {
  if (shared.slots[first_slot_[s] + slot].empty()) return false;
  const FaceId face = w_.patch[s].solid->slot(slot).block->brep().face_of(h);
  return !kept_.rest[s].is_loaded(slot, face);
}

BorderEdge KeptBlocks::border_edge(Operand s, std::uint32_t slot, HalfEdgeId h) const {
  BorderEdge edge = trimmed_[s]->border_edge(slot, h);
  if (edge.border == TrimmedBlock::none)
    throw InternalError("an edge of the result has only one face");
  edge.slot += first_slot_[s];
  return edge;
}

}  // namespace sectile
