// What must hold before a mesh can be written.
#pragma once

#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

/// Sizes and indices fit together and all coordinates are finite. Throws FileError.
void require_writable(const PolygonMesh& mesh, std::string_view name);

/// There are only triangles, as `format` needs them. Throws FileError.
void require_triangles(const PolygonMesh& mesh, std::string_view name, std::string_view format);

/// The nearest float. Throws FileError if it is beyond `most`, the largest number of `format`.
float writable_float(double value, std::string_view name, std::string_view format, float most);

}  // namespace sectile
