// Binary STL: 80 bytes of anything, the number of triangles, and 50 bytes for each.
#pragma once

#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

/// Has the file just the size that its number of triangles asks for? A binary file may begin with
/// "solid" too.
bool has_size_of_binary_stl(std::string_view content);
/// At least long enough for a number of triangles.
bool may_be_binary_stl(std::string_view content);
PolygonMesh read_stl_binary(std::string_view content, std::string_view name);

}  // namespace sectile
