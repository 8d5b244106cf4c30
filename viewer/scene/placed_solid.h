// A solid where the modeller shows it.
#pragma once

#include "sectile/sectile.h"

namespace sectile::viewer {

/// Moves without a turn or a scale take corners that are doubles to doubles, as snapping does when
/// it makes them meet others; all else is exact.
Solid placed_solid(const Solid& solid, const Transform& by);

}  // namespace sectile::viewer
