// How the shells of a solid lie within each other.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "storage/solid_data.h"

namespace sectile {

/// How much material of other faces is around the outer side of a point within a face: 0 where all
/// shells are nested as those of a solid are. The face is not parallel to
/// the x axis. Throws InvalidSolid if another face lies on the point.
int material_outside(const SolidData& data, const Kernel& kernel, FaceId face);

}  // namespace sectile
