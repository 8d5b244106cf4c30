// Which faces of two solids may meet.
#pragma once

#include <optional>

#include "boolean/near/common_hubs.h"
#include "boolean/near/crowded_crossings.h"
#include "boolean/near/crowded_lines.h"
#include "boolean/near/slot_pairs.h"
#include "boolean/neighborhoods/neighborhoods.h"
#include "boolean/workspace.h"

namespace sectile {

/// What may meet, but for what is left out: faces that both boundaries have
/// (Workspace::common_faces), and pairs at crowded lines and points.
struct Near {
  SlotPairs slots;
  CommonHubs hubs;
  FacePairs pairs;                    ///< of the solids' faces; those of hubs as directions tell
  std::optional<CrowdedLines> lines;  ///< where pairs were left out, if they were
  CrowdedCrossings crossings;         ///< where they were, too
};

/// What is `wanted` may be found without all pairs. Fills in what of both is left out.
Near find_near(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
               const Wanted& wanted);

}  // namespace sectile
