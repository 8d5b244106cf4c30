// Looks for faces of a solid by their boxes.
#pragma once

#include <algorithm>
#include <vector>

#include "storage/solid_data.h"

namespace sectile {

/// The faces whose boxes satisfy meets(box), ascending; meets must hold for any box that contains a
/// box for which it holds. Blocks that satisfy passes_over(block) are passed over.
template <class Meets, class PassesOver>
std::vector<FaceId> faces_where(const SolidData& solid, const Meets& meets,
                                const PassesOver& passes_over) {
  std::vector<FaceId> faces;
  solid.slot_tree().query(meets, [&](std::uint32_t item) {
    const std::uint32_t slot = solid.slots_in_tree()[item];
    if (passes_over(*solid.slot(slot).block)) return;
    solid.slot(slot).block->tree().query(
        meets, [&](std::uint32_t f) { faces.push_back(solid.face(slot, FaceId(f))); });
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}
template <class Meets>
std::vector<FaceId> faces_where(const SolidData& solid, const Meets& meets) {
  return faces_where(solid, meets, [](const Block&) { return false; });
}

}  // namespace sectile
