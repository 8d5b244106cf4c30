// The order of the cuts around each site.
#pragma once

#include "boolean/null_edges/sites_by_place.h"
#include "boolean/null_edges/subdivision.h"

namespace sectile {

/// Where a cut leaves a site.
struct OrderedEnd {
  PlannedEndId planned;
  /// Not the planned one where a face touches itself and the corner is that of another vertex.
  SiteId site;
  HalfEdgeId corner;  ///< of the patch; invalid within a face
};

struct CutOrder {
  Table<SiteId, IdRange<CutEndId>> at;  ///< counter-clockwise
  Table<CutEndId, OrderedEnd> ends;     ///< by site
};

CutOrder order_cuts(const Workspace& w, const Neighborhoods& neighborhoods, const CutPlan& plan,
                    const SitesByPlace& places, const SiteVertices& vertices);

}  // namespace sectile
