// A face may touch itself: several of its vertices, of one loop or of several, are at one place.
// Each corner then may seem to enclose parts that lie beyond another of them.
#pragma once

#include "boolean/null_edges/null_edges.h"
#include "boolean/null_edges/sites_by_place.h"
#include "boolean/null_edges/subdivision.h"

namespace sectile {

/// Null edges between corners of one face at one place.
struct OperandBridges {
  std::vector<NullEdge> null_edges;
  std::vector<FaceId> faces;  ///< the loaded faces that have such
};

/// Where a face touches itself at a place and several of its vertices there have cuts, null edges
/// link them so that each corner encloses nothing but a part of the face.
PerOperand<OperandBridges> bridge_touching_corners(Workspace& w, const CutPlan& plan,
                                                   const SitesByPlace& places,
                                                   const SiteVertices& vertices);

}  // namespace sectile
