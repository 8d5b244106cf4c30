// Points through which very many edges run, each in a direction of its own: no vertex is there that
// would tell, and all boxes around such a point overlap.
#pragma once

#include <vector>

#include "geometry/kernel.h"
#include "search/sided_polygons.h"

namespace sectile {

/// Those in which edges of very many polygons cross edges of others that they may meet: nearly all
/// where most pairs of boxes overlap because of such points, and few others. Where most edges run
/// through comes first. The time is that of a few pairs for each polygon.
std::vector<Construction> crowded_crossings(const Kernel& kernel, const SidedPolygons& polygons);

}  // namespace sectile
