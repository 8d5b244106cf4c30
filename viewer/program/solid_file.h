// Solids of the files on the command line.
#pragma once

#include <filesystem>

#include "sectile/sectile.h"

namespace sectile::viewer {

/// Throws InvalidSolid with a message that names the file.
Solid solid_of_file(const std::filesystem::path& path, const PolygonMesh& mesh);

}  // namespace sectile::viewer
