// Phase 1: reduction (paper, section 5, steps 1 to 8). Finds all contacts of the two boundaries.
//
// Afterwards they meet only in places (points) and in open segments between neighbouring places.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

using FacePairs = std::vector<std::pair<FaceId, FaceId>>;

/// Where the two boundaries meet.
struct Contacts {
  Table<ContactId, Contact> contacts;   ///< ascending by entities, crossings last
  Table<PlaceId, PointId> places;       ///< the point of each place
  std::vector<SegmentRecord> segments;  ///< one for each two entities that share one

  PointId point(PlaceId place) const { return places[place]; }
};

/// The contacts of pairs of loaded faces that may meet. Vertices of the patches that are at one
/// place share one point afterwards.
Contacts reduce(Workspace& w, const FacePairs& candidates);

}  // namespace sectile
