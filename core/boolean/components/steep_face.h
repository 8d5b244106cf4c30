// A face that a ray in x does not run along.
#pragma once

#include <functional>
#include <optional>

#include "storage/solid_data.h"

namespace sectile {

struct SteepFace {
  std::uint32_t slot;
  FaceId face;  ///< of the slot's block
};

/// Of a face of a solid and a few dozen around it, over edges, the one that is closest to being
/// across x; none if all lie along it. Goes over no face that is not free(slot, face).
std::optional<SteepFace> steep_face_near(
    const SolidData& solid, SteepFace start,
    const std::function<bool(std::uint32_t slot, FaceId face)>& free);

}  // namespace sectile
