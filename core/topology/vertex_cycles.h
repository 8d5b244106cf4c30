// Vertices are what the cycles of half-edges around them say.
#pragma once

#include <vector>

#include "topology/brep.h"

namespace sectile {

/// Makes a vertex for each cycle of half-edges that leave one corner, and lets them leave it. All
/// links but the origins stand; `start` has the point where each half-edge begins.
void make_vertices(Brep& brep, const std::vector<PointId>& start);

}  // namespace sectile
