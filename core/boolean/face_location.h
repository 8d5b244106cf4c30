// Point in face: inside, on an edge, on a vertex, or outside, exactly.
#pragma once

#include "boolean/entity.h"
#include "boolean/patch.h"
#include "geometry/probe.h"

namespace sectile {

/// Where a point of a face's plane lies: the face, one of its edges or vertices, or nothing.
Entity locate(const Kernel& kernel, const Patch& patch, FaceId face, const Probe& point);

}  // namespace sectile
