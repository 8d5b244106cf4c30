#include "scene/mesh_parts.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {

std::vector<MeshPart> read_parts(const std::filesystem::path& path) {
  std::vector<MeshPart> parts;
  for (NamedMesh& mesh : read_model(path).meshes) {
    MeshPart part;
    part.name = mesh.name.empty() ? path.stem().string() : std::move(mesh.name);
    if (mesh.colour) {
      const auto& [red, green, blue] = *mesh.colour;
      part.colour = {red / 255.0f, green / 255.0f, blue / 255.0f};
    }
    part.mesh = std::make_shared<const PolygonMesh>(std::move(mesh.mesh));
    parts.push_back(std::move(part));
  }
  return parts;
}

std::optional<MeshColour> in_bytes(const std::optional<NodeColour>& colour) {
  if (!colour) return std::nullopt;
  MeshColour bytes;
  for (std::size_t i = 0; i < 3; ++i)
    bytes[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp((*colour)[i], 0.0f, 1.0f)));
  return bytes;
}

}  // namespace sectile::viewer
