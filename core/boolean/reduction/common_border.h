// Two faces that meet in a corner of both, or in an edge of both, and in nothing else: where both
// boundaries have vertices in the same places, so it is with most pairs of faces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boolean/reduction/contact_table.h"

namespace sectile {

struct CommonBorder {
  /// The half-edges that leave the common corners, one or two.
  std::array<PerOperand<HalfEdgeId>, 2> corner;
  std::size_t corners = 0;
  /// Between two, where that is an edge of the face.
  PerOperand<HalfEdgeId> edge;
};

/// Of two faces, by the half-edges that come near the other one. Nothing if more has to be asked.
std::optional<CommonBorder> only_common_border(
    const Workspace& w, const PerOperand<std::vector<SidedHalfEdge>>& half_edges);

}  // namespace sectile
