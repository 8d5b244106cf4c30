// Pairs of faces of two solids that may meet, where very many are long and thin and reach between
// each other: boxes of blocks and nodes say little about them.
#pragma once

#include <optional>
#include <span>

#include "boolean/near/common_hubs.h"
#include "boolean/near/crowded_crossings.h"
#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"

namespace sectile {

/// Of faces in some slots of each solid, but for those that have a common hub. Some are found
/// several times.
FacePairs pairs_of_crowded_faces(const Workspace& w, const SolidData& a, const SolidData& b,
                                 const PerOperand<std::span<const std::uint32_t>>& slots,
                                 const CommonHubs& hubs);

/// The same without faces that meet in nothing but a point through which very many edges run. None
/// if there is no such point.
struct PairsBesideCrossings {
  FacePairs pairs;
  CrowdedCrossings crossings;
};
std::optional<PairsBesideCrossings> pairs_beside_crossings(
    const Workspace& w, const SolidData& a, const SolidData& b,
    const PerOperand<std::span<const std::uint32_t>>& slots, const CommonHubs& hubs);

}  // namespace sectile
