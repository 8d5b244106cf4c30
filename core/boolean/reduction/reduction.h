// Phase 1: reduction (paper, section 5, steps 1 to 8). Finds all contacts of the two boundaries.
//
// Afterwards they meet only in places (points) and in open segments between neighbouring places.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

using FacePairs = std::vector<std::pair<FaceId, FaceId>>;

/// Fills contacts, places and records for pairs of loaded faces that may meet.
void reduce(Workspace& w, const FacePairs& candidates);

}  // namespace sectile
