// Edges end to end.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/edges_by_line.h"

namespace sectile {

/// The paths that edges make, each from a point with one edge, or with more than two, to the next
/// such point. An edge is in one path at most; those in rings are in none.
std::vector<std::vector<std::uint32_t>> edge_chains(std::span<const PointPair> edges);

}  // namespace sectile
