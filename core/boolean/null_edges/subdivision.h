// Steps (1) to (3), (5), (6): edges are divided at the sites on them.
#pragma once

#include "boolean/null_edges/cut_plan.h"

namespace sectile {

/// Where a site is in the patch, once its edge is divided.
struct SiteVertex {
  VertexId vertex;     ///< invalid within a face
  HalfEdgeId forward;  ///< on an edge: the half-edge that goes on from there
};
using SiteVertices = Table<SiteId, SiteVertex>;

SiteVertices subdivide_edges(Workspace& w, const Contacts& contacts, const CutPlan& plan);

}  // namespace sectile
