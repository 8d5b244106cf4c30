// The meshes of a file, as they come into a scene: one node for each.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "sectile/files.h"

namespace sectile::viewer {

struct MeshPart {
  std::string name;
  std::optional<NodeColour> colour;
  std::shared_ptr<const PolygonMesh> mesh;
  double scale = 1;  ///< to millimetres
};

struct MeshParts {
  std::vector<MeshPart> parts;
  std::string note;  ///< what a person should know of how they were read: sentences, or empty
};

/// What has no name in the file is called after it. Throws FileError.
MeshParts read_parts(const std::filesystem::path& path);
/// How many millimetres the unit has.
double millimetres(LengthUnit unit);

/// As files hold it.
std::optional<MeshColour> in_bytes(const std::optional<NodeColour>& colour);

}  // namespace sectile::viewer
