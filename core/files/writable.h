// What must hold before a mesh can be written.
#pragma once

#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

/// Sizes and indices fit together and all coordinates are finite. Throws FileError.
void require_writable(const PolygonMesh& mesh, std::string_view name);

/// There are only triangles. Throws FileError.
void require_triangles(const PolygonMesh& mesh, std::string_view name);

}  // namespace sectile
