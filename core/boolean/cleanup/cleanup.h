// Phase 7: edges between parts of one and the same face, and vertices in the middle of straight
// edges that nothing needs any more, disappear.
#pragma once

#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "topology/brep.h"

namespace sectile {

/// `seams`: the edges that may go. `followed`: faces whose ids are to be kept true.
void clean_up(Brep& brep, const Geometry& geometry, const std::vector<EdgeId>& seams,
              std::span<FaceId> followed = {});

}  // namespace sectile
