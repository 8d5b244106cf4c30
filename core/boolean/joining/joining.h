// Phase 4: the null edges at the two ends of each cut are joined by the two sides of the cut.
#pragma once

#include "boolean/null_edges/null_edges.h"

namespace sectile {

/// The two sides of a carrier that is cut, on real faces: along the segment, and against it.
struct CutSides {
  HalfEdgeId forward, backward;
};

struct JoinedCuts {
  Table<CarrierId, CutSides> sides;
  /// Was a loaded face divided, or are corners of it linked?
  PerOperand<Table<FaceId, std::uint8_t>> divided;
};

/// Between the sides of each cut a face without area remains (FaceKind::null). Each part of a face
/// that was cut gets its own face, with its outer loop first.
JoinedCuts join_null_edges(Workspace& w, const Neighborhoods& neighborhoods, const Cuts& cuts);

}  // namespace sectile
