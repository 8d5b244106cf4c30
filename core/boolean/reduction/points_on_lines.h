// The points of vertices on crowded lines.
//
// Vertices at one place share one point, as contacts say. There, pairs that would have said so may
// have been left out (boolean/near/crowded_lines.h).
#pragma once

#include "boolean/reduction/places_by_point.h"

namespace sectile {

void share_points_on_lines(Workspace& w, const Contacts& found, const PlacesByPoint& places);

}  // namespace sectile
