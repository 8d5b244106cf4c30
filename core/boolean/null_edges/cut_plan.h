// Which cuts end where: each cut has two ends, and those at one place of one entity form a site.
#pragma once

#include <array>

#include "boolean/neighborhoods/neighborhoods.h"

namespace sectile {

/// A place on one entity of one operand at which cuts end.
struct Site {
  Operand operand;
  Entity entity;
  PlaceId place;
  IdRange<PlannedEndId> ends;
};

/// One end of a cut: the carrier is cut along the segment and ends at its place[which].
struct PlannedEnd {
  SiteId site;
  SegmentId segment;
  CarrierId carrier;
  std::uint8_t which;
};

struct CutPlan {
  Table<SiteId, Site> sites;             ///< ascending by operand, entity and place
  Table<PlannedEndId, PlannedEnd> ends;  ///< by site
  /// Of a carrier that is cut: its ends at place[0] and place[1].
  Table<CarrierId, std::array<PlannedEndId, 2>> of_carrier;
};

CutPlan plan_cuts(const Workspace& w, const Neighborhoods& neighborhoods);

}  // namespace sectile
