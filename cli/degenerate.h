// Triangles that the rounding of exact points flattened.
#pragma once

#include "sectile/files.h"
#include "sectile/mesh.h"

namespace sectile::cli {

/// How many triangles have no area once their coordinates are rounded as the format does (doubles,
/// or floats in binary STL and 3MF). Decided exactly unless coordinates of one triangle differ in
/// size by more than 2^900.
std::size_t count_degenerate_triangles(const PolygonMesh& triangles, FileFormat format);

}  // namespace sectile::cli
