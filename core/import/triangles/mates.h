// The neighbours of triangles, chunk by chunk.
#pragma once

#include <optional>

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// The shells, in the order of their first triangles.
struct ShellOfTriangle {
  std::uint32_t count = 1;
  std::vector<std::uint32_t> of;  ///< per triangle; empty if there is one shell
};

/// Finds the mates of all corners. None if the mesh is not a surface with two triangles at each
/// edge and one cycle of triangles around each point; some mates are wrong or missing then.
std::optional<ShellOfTriangle> find_mates(TriangleMesh& mesh);

}  // namespace sectile
