#include "program/solid_file.h"

namespace sectile::viewer {

Solid solid_of_file(const std::filesystem::path& path, const PolygonMesh& mesh) {
  try {
    return Solid::from_mesh(mesh);
  } catch (const InvalidSolid& error) {
    throw InvalidSolid(error.reason(), path.string() + ": " + error.what(), error.face(),
                       error.vertex());
  }
}

}  // namespace sectile::viewer
