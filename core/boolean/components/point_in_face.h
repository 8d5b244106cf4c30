// Points within a face, off its edges.
#pragma once

#include <functional>

#include "boolean/workspace.h"

namespace sectile {

/// The first point within a loaded face of the patch for which take(point) is true, or none. Such
/// points are near its corners: `part` of the way from each to the edge that cuts it off. Adds
/// points and planes to the geometry.
PointId point_in_face(Workspace& w, const Patch& patch, FaceId face, double part,
                      const std::function<bool(PointId)>& take);

/// A plane across an axis.
PlaneId plane_across(Workspace& w, int axis, double at);

}  // namespace sectile
