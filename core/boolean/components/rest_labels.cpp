#include "boolean/components/rest_labels.h"

#include <algorithm>

namespace sectile {

RestLabels::RestLabels(const Patch& patch) {
  if (patch.whole || patch.face_in_solid.size() == patch.solid->face_count()) return;
  solid_ = patch.solid;
  touched_.assign(solid_->slots().size(), 0);
  first_.assign(solid_->slots().size(), none);
  for (const FaceId f : patch.face_in_solid) {
    const std::uint32_t s = solid_->slot_of(f);
    touched_[s] = 1;
    of_member(s, solid_->local(s, f).value()) = loaded;
  }
}

std::uint32_t RestLabels::count(std::uint32_t slot) const {
  return is_touched(slot) ? solid_->slot(slot).faces : solid_->slot(slot).pieces;
}

void RestLabels::add_members(std::uint32_t slot) {
  first_[slot] = static_cast<std::uint32_t>(labels_.size());
  labels_.resize(labels_.size() + count(slot), unknown);
}

std::span<const std::uint8_t> RestLabels::labels(std::uint32_t slot) const {
  if (first_[slot] == none) return {&far_label_, 1};
  return std::span(labels_).subspan(first_[slot], count(slot));
}

bool RestLabels::has(std::uint32_t slot, std::uint8_t label) const {
  return std::ranges::find(labels(slot), label) != labels(slot).end();
}

bool RestLabels::has_only(std::uint32_t slot, std::uint8_t label) const {
  return std::ranges::all_of(labels(slot), [&](std::uint8_t l) { return l == label; });
}

void RestLabels::label_all_but(std::span<const std::uint32_t> near, std::uint8_t label) {
  for (const std::uint32_t slot : near)
    if (first_[slot] == none) add_members(slot);
  far_label_ = label;
}

}  // namespace sectile
