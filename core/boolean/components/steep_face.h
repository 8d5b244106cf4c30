// A face that a ray in x does not run along.
#pragma once

#include <functional>
#include <optional>

#include "storage/face_at.h"
#include "storage/solid_data.h"

namespace sectile {

/// Of a face of a solid and a few dozen around it, over edges, the one that is closest to being
/// across x; none if all lie along it. Goes over no face that is not free(face).
std::optional<FaceAt> steep_face_near(const SolidData& solid, const FaceAt& start,
                                      const std::function<bool(const FaceAt&)>& free);

}  // namespace sectile
