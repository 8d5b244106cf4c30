// A split as a Boolean: the half-space as a block that reaches beyond the solid.
#pragma once

#include <optional>

#include "sectile/sectile.h"

namespace sectile::viewer {

/// A solid whose intersection with `solid` is its part above (or below) the plane. Empty if no such
/// block has corners that doubles hold exactly: then the steps of the split cannot be told.
std::optional<Solid> half_space_block(const Solid& solid, const HalfSpace& plane, bool above);

}  // namespace sectile::viewer
