// Edges on one line of which not all meet in a pair of faces that is tested.
#pragma once

#include <span>

#include "boolean/reduction/reduction.h"
#include "numbers/disjoint_sets.h"

namespace sectile {

/// Unites edges of A that run along one line on which edges lie beside each other. `records` are
/// between edges.
void unite_on_lines(const Workspace& w, std::span<const SegmentRecord> records,
                    DisjointSets& edges);

}  // namespace sectile
