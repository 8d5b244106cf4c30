// Point in face: inside, on an edge, on a vertex, or outside, exactly.
#pragma once

#include <vector>

#include "boolean/entity.h"
#include "boolean/patch.h"
#include "geometry/probe.h"

namespace sectile {

/// Where a point of a face's plane lies: in the face, on edges or vertices of it (on several where
/// the face touches itself), or nowhere. Replaces what `found` holds.
void locate(const Kernel& kernel, const Patch& patch, FaceId face, const Probe& point,
            std::vector<Entity>& found);

}  // namespace sectile
