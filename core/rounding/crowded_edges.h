// Edges on which corners of others lie, side by side.
#pragma once

#include <span>

#include "rounding/clear_pairs.h"

namespace sectile {

/// Do corners of triangles lie on more than two edges of others each, on the average, as far as
/// doubles tell? No place near by is right for such a corner then, but one that it has in common
/// with all these edges. `slack`: no coordinate was farther away from where it is.
bool have_crowded_edges(std::span<const PlacedTriangle> triangles, double slack);

}  // namespace sectile
