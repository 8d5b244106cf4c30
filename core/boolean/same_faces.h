// Boundaries that are the same, face by face.
#pragma once

#include <atomic>

#include "storage/solid_data.h"

namespace sectile {

/// Has each face of one boundary the same corners, in the same order, as one of the other, but for
/// those within straight edges? Blocks that both have are not looked into. False does not mean that
/// they bound different sets. Throws Cancelled soon after `cancel` is set.
bool have_same_faces(const SolidData& a, const SolidData& b,
                     const std::atomic<bool>* cancel = nullptr);

}  // namespace sectile
