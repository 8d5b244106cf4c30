// The vertices of each chunk of a mesh of triangles.
#pragma once

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// Sets `vertex` and `vertex_count`, once the corners stand in their chunks.
void number_vertices_in_chunks(TriangleMesh& mesh);

}  // namespace sectile
