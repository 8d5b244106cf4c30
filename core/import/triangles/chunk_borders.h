// What chunks have in common: edges and points.
#pragma once

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// Finds what is beyond all borders, once all chunks are read. False if the edges between chunks,
/// or those between points in several of them, have not two triangles each, one on each side.
bool match_borders(TriangleMesh& mesh);

/// Is there one cycle of triangles around each point? `marks` has those within chunks, as the
/// reader has left them, and is used up.
bool has_plain_points(const TriangleMesh& mesh, std::span<std::uint32_t> marks);

}  // namespace sectile
