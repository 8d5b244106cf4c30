// A face in triangles.
#pragma once

#include <array>
#include <vector>

#include "geometry/kernel.h"
#include "topology/brep.h"

namespace sectile {

/// Triangles that cover a face exactly, by the rounded places of their corners. The kernel knows
/// the plane of the face.
std::vector<std::array<Vec3, 3>> face_triangles(const Brep& brep, const Kernel& kernel,
                                                FaceId face);

}  // namespace sectile
