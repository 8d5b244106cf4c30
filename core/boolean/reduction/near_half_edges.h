// Which half-edges of a face come near a face of the other solid.
#pragma once

#include <vector>

#include "boolean/reduction/contact_table.h"

namespace sectile {

/// Adds those of a face of a solid, without their sides, or all of a small face. Of very many
/// around one vertex, as if the vertex is near, only one and those that have more in common with
/// the other face. Returns whether these are all of the face.
bool near_half_edges(const Workspace& w, Operand solid, FaceId face, FaceId across,
                     std::vector<SidedHalfEdge>& out);

}  // namespace sectile
