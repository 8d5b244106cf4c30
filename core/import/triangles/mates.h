// The neighbours of triangles, chunk by chunk.
#pragma once

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// Finds the mates of all corners. False if the mesh is not one surface with two triangles at each
/// edge, one cycle of triangles around each point and all of them in one shell; some mates are
/// wrong or missing then.
bool find_mates(TriangleMesh& mesh);

}  // namespace sectile
