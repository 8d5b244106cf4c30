// Meshes put together as one soup.
#pragma once

#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

/// `more` after `mesh`, its corners numbered on. Throws FileError if there are more positions than
/// corners can count.
void append(PolygonMesh& mesh, const PolygonMesh& more, std::string_view name);

}  // namespace sectile
