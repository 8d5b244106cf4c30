#include "boolean/components/rest_labels.h"

#include <algorithm>
#include <utility>

namespace sectile {

RestLabels::RestLabels(const Patch& patch) {
  if (patch.whole || patch.face_in_solid.size() == patch.solid->face_count()) return;
  solid_ = patch.solid;
  left_ = LeftPieces(patch);
  region_.assign(solid_->slots().size(), none);
  first_.assign(solid_->slots().size(), none);
}

void RestLabels::set_regions(ClearRegions regions) {
  region_ = std::move(regions.of_slot);
  region_label_.assign(regions.count, unknown);
  for (std::uint32_t s = 0; s < region_.size(); ++s)
    if (is_touched(s)) region_[s] = none;
}

void RestLabels::add_pieces(std::uint32_t slot) {
  first_[slot] = static_cast<std::uint32_t>(labels_.size());
  labels_.resize(labels_.size() + count(slot), unknown);
}

std::span<const std::uint8_t> RestLabels::labels(std::uint32_t slot) const {
  if (region_[slot] != none) return {&region_label_[region_[slot]], 1};
  static constexpr std::uint8_t all = unknown;
  if (first_[slot] == none) return {&all, std::min(count(slot), 1u)};
  return std::span(labels_).subspan(first_[slot], count(slot));
}

bool RestLabels::has(std::uint32_t slot, std::uint8_t label) const {
  return std::ranges::find(labels(slot), label) != labels(slot).end();
}

bool RestLabels::has_only(std::uint32_t slot, std::uint8_t label) const {
  return std::ranges::all_of(labels(slot), [&](std::uint8_t l) { return l == label; });
}

}  // namespace sectile
