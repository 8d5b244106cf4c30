// Binary STL: 80 bytes of anything, the number of triangles, and 50 bytes for each.
#pragma once

#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

/// A binary file may begin with "solid" too, so its size decides.
bool is_binary_stl(std::string_view content);
PolygonMesh read_stl_binary(std::string_view content, std::string_view name);

}  // namespace sectile
