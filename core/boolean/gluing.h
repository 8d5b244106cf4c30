// Phase 7: the pieces that stay are turned if need be and glued, two half-planes for each wedge of
// material; then vertices are what the cycles of edges around them say.
#pragma once

#include <memory>
#include <span>

#include "boolean/components.h"

namespace sectile {

/// The result's data, and the half-edges (even ones) of the edges along which pieces were glued.
struct Glued {
  std::shared_ptr<SolidData> data;
  std::vector<EdgeId> seams;
};

Glued glue(const Workspace& w, Operation operation, std::span<const WedgePair> wedges,
           const FaceLabels& kept);

}  // namespace sectile
