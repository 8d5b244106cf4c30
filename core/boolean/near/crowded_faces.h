// Pairs of faces of two solids that may meet, where very many are long and thin and reach between
// each other: boxes of blocks and nodes say little about them.
#pragma once

#include <span>

#include "boolean/near/common_hubs.h"
#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"

namespace sectile {

/// Of faces in some slots of each solid, but for those that have a common hub. Some are found
/// several times.
FacePairs pairs_of_crowded_faces(const Workspace& w, const SolidData& a, const SolidData& b,
                                 const PerOperand<std::span<const std::uint32_t>>& slots,
                                 const CommonHubs& hubs);

}  // namespace sectile
