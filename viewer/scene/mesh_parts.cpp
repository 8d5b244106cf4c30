#include "scene/mesh_parts.h"

#include "sectile/files.h"

namespace sectile::viewer {

std::vector<MeshPart> read_parts(const std::filesystem::path& path) {
  std::vector<MeshPart> parts;
  for (NamedMesh& mesh : read_model(path).meshes) {
    MeshPart part;
    part.name = mesh.name.empty() ? path.stem().string() : std::move(mesh.name);
    part.mesh = std::make_shared<const PolygonMesh>(std::move(mesh.mesh));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace sectile::viewer
