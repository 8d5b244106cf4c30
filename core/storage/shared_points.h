// Where a solid touches itself, several of its vertices are at one point.
#pragma once

#include "geometry/kernel.h"
#include "topology/brep.h"

namespace sectile {

/// Lets all vertices at one place have the same point, that of the first of them. Those that come
/// from different blocks have points of their own.
void share_points(Brep& brep, const Kernel& kernel);

}  // namespace sectile
