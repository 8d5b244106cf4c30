// Closes structures of which only a part is there.
#pragma once

#include <span>

#include "topology/brep.h"

namespace sectile {

/// Half-edges `open` have no loop: what lies beyond them is elsewhere. Each becomes followed by the
/// one that ends the fan of faces around its end, and each of their cycles the loop of a face of
/// kind `rest`. All faces have a kind.
void close_open_ends(Brep& brep, std::span<const HalfEdgeId> open);

}  // namespace sectile
