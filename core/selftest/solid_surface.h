// The boundary of a solid as triangles.
#pragma once

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"
#include "topology/brep.h"

namespace sectile {

/// Triangles of all faces, in the order of the faces. Faces of which there are none, because their
/// edges cross each other, are added to `crossing`.
TriangleSurface surface_of(const Brep& brep, const Kernel& kernel, std::vector<FaceId>& crossing);

}  // namespace sectile
