// Phase 6: the pieces that stay are turned if need be and glued, two half-planes for each wedge of
// material; then vertices are what the cycles of edges around them say.
//
// Blocks that stay as they are go into the result as they are; of others, what stays and was not
// touched. What is glued is made anew.
#pragma once

#include <memory>
#include <span>

#include "boolean/components/components.h"
#include "storage/cut_into_blocks.h"
#include "storage/kept_loops.h"
#include "storage/shared_slots.h"

namespace sectile {

/// What is made anew, as one structure; `rest` faces stand for the blocks that are shared.
struct Glued {
  Brep brep;  ///< points and planes are those of the workspace
  /// The edges along which pieces were glued.
  std::vector<EdgeId> seams;
  /// Of edges 0, 1, …: each leads from its even half-edge to this border edge of a shared block.
  std::vector<BorderEdge> outside;
  /// The slots of A and then of B, with the blocks that are shared or trimmed, or have loops that
  /// are kept.
  SharedSlots shared;
  std::vector<KeptLoops> kept_loops;
};

/// `kept`: label 1 for the faces that stay. `wedges`: of the neighborhoods, for this operation.
/// Adds to the workspace's geometry.
Glued glue(Workspace& w, Operation operation, const Neighborhoods& neighborhoods,
           const Wedges& wedges, const JoinedCuts& joined, const FaceLabels& kept);

}  // namespace sectile
