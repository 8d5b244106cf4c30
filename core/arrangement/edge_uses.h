// Which faces have an edge in common.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/facets.h"

namespace sectile::arrangement {

/// The edge that leaves a corner, by its ends.
struct EdgeUse {
  PointId low, high;
  std::uint32_t corner;

  bool has_same_ends(const EdgeUse& other) const { return low == other.low && high == other.high; }
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Of all edges of some faces (per face: is it one of them?), in order.
std::vector<EdgeUse> edge_uses(const Facets& facets, const std::vector<std::uint8_t>& wanted);

}  // namespace sectile::arrangement
