// Points through which edges of very many faces run, each in a direction of its own
// (search/crossing_fans.h).
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/facets.h"
#include "search/crossing_fans.h"

namespace sectile::arrangement {

/// Fans around such points.
CrossingFans crossing_fans(const Facets& facets, const Kernel& kernel);

struct CrowdedPoint {
  Construction how;
  std::vector<std::uint32_t> faces;  ///< all that have it in an edge or a corner, ascending
};
std::vector<CrowdedPoint> crowded_points(const CrossingFans& fans);

}  // namespace sectile::arrangement
