#include "boolean/components/rest_labels.h"

namespace sectile {

RestLabels::RestLabels(const Patch& patch) : solid_(patch.solid) {
  if (patch.whole || patch.face_in_solid.size() == solid_->face_count()) return;
  const std::size_t slots = solid_->slots().size();
  touched_.assign(slots, 0);
  for (const FaceId f : patch.face_in_solid) touched_[solid_->slot_of(f)] = 1;
  first_.reserve(slots + 1);
  first_.push_back(0);
  for (std::uint32_t s = 0; s < slots; ++s) {
    const Slot& slot = solid_->slot(s);
    const std::size_t members = slot.empty()  ? 0
                                : touched_[s] ? slot.block->brep.face_count()
                                              : slot.block->pieces().count;
    first_.push_back(first_.back() + static_cast<std::uint32_t>(members));
  }
  labels_.assign(first_.back(), unknown);
  for (const FaceId f : patch.face_in_solid) {
    const std::uint32_t s = solid_->slot_of(f);
    of_member(s, solid_->local(s, f).value()) = loaded;
  }
}

}  // namespace sectile
