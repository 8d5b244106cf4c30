// Blocks straight from a mesh of triangles.
#pragma once

#include "import/triangles/flat_part.h"
#include "import/triangles/triangle_mesh.h"

namespace sectile {

struct TriangleBlocks {
  std::vector<Slot> slots;          ///< one per chunk; empty where all triangles are in the part
  std::vector<BorderEdge> outside;  ///< per edge that leaves the part: the same edge of a block
};

/// One block per chunk, of all its triangles that are not in the part. Links to the part lead
/// nowhere yet.
TriangleBlocks make_triangle_blocks(TriangleMesh&& mesh, const FlatPart& part,
                                    std::uint32_t origin);

}  // namespace sectile
