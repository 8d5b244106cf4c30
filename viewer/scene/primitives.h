// The solids that primitives stand for.
#pragma once

#include "scene/scene.h"

namespace sectile::viewer {

/// Blocks, wedges and all that stands along z are centred at the origin. The parameters are those
/// of sectile/primitives.h; throws std::invalid_argument, which says what is wrong.
Solid solid_of(const Primitive& primitive);

}  // namespace sectile::viewer
