// Phase 5: the null edges at the two ends of each cut are joined by the two sides of the cut.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Between the sides of each cut a face without area remains (FaceKind::null). Sets
/// Carrier::forward and backward.
void join_null_edges(Workspace& w);

}  // namespace sectile
