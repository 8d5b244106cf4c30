// Point in solid, by one exact ray.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Is a point, which is not on the boundary of an operand, inside it? May add to the workspace's
/// geometry.
bool is_inside(Workspace& w, Operand operand, PointId point);

}  // namespace sectile
