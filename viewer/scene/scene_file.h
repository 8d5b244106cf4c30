// Scenes as JSON files. All numbers come back as they were, to the last bit.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace sectile::viewer {

struct SceneDocument {
  Scene scene;
  std::string view;  ///< camera and view settings: any JSON value as text, or empty
};

bool is_scene_file(const std::filesystem::path& path);  ///< by its extension

/// The file appears whole or not at all. Throws FileError.
void write_scene(const std::filesystem::path& path, const SceneDocument& document);
/// Throws FileError, whose message names the file, what is wrong and where.
SceneDocument read_scene(const std::filesystem::path& path);

/// The same as text. `name` is what errors call it. Throws FileError.
std::string scene_text(const SceneDocument& document);
SceneDocument parse_scene(std::string_view text, const std::string& name);

/// Meshes kept in files of their own, beside the scene: `name_of` gives (and may write) the file of
/// a mesh; `mesh_of` reads the one of that name.
using MeshPointer = std::shared_ptr<const PolygonMesh>;
using NameOfMesh = std::function<std::string(const MeshPointer&)>;
using MeshOfName = std::function<MeshPointer(const std::string&)>;
std::string scene_text(const SceneDocument& document, const NameOfMesh& name_of);
SceneDocument parse_scene(std::string_view text, const std::string& name,
                          const MeshOfName& mesh_of);
std::string mesh_text(const PolygonMesh& mesh, const std::string& name);
MeshPointer parse_mesh(std::string_view text, const std::string& name);

}  // namespace sectile::viewer
