// Do the shells of a boundary keep away from each other?
#pragma once

#include "import/shells.h"

namespace sectile {

/// False if any faces of different shells may touch. Where a corner or an edge of one lies in a
/// face of another, a boundary is not divided as that of a solid is.
bool shells_are_apart(const Brep& brep, const Geometry& geometry, const Shells& shells);

}  // namespace sectile
