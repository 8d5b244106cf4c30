// Wedges of material along one line, of which some are above others in the same directions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "rounding/edge_sectors.h"

namespace sectile {

/// Wedges that have half-planes of the line in common, each with some of the others.
struct WedgeGroup {
  std::vector<std::uint32_t> wedges;
  EdgeSectors::Wedge all;  ///< from the right side of the first one to the left one of the last
};

/// All wedges around a line that goes up on an axis: each is in one group, and no two groups have a
/// half-plane in common. None if the wedges are all around the line.
std::vector<WedgeGroup> groups_of_wedges(const Kernel& kernel, int axis,
                                         std::span<const EdgeSectors::Wedge> wedges);

}  // namespace sectile
