#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "scene/primitive_kind.h"
#include "scene/scene_file.h"
#include "scene/scene_json.h"

namespace sectile::viewer {

namespace {

using Json = nlohmann::ordered_json;

class SceneWriter {
 public:
  explicit SceneWriter(const NameOfMesh& name_of) : name_of_(name_of) {}

  std::string write(const SceneDocument& document) {
    Json json;
    json["kind"] = scene_file_kind;
    json["version"] = scene_file_version;
    if (!document.view.empty()) json["view"] = view(document.view);
    json["roots"] = document.scene.roots();
    json["nodes"] = Json::array();
    for (const NodeId id : document.scene.in_order())
      json["nodes"].push_back(node(document.scene.at(id)));
    std::string text = json.dump(1);
    // Meshes are most of a file: they are written beside the rest, not through it.
    text.erase(text.find_last_of('}'));
    text += ", \"meshes\": [";
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      text += i == 0 ? "\n" : ",\n";
      text += name_of_ ? Json{{"file", name_of_(meshes_[i])}}.dump()
                       : mesh_text(*meshes_[i], "mesh " + std::to_string(i + 1));
    }
    return text += "]}\n";
  }

 private:
  static Json view(const std::string& text) {
    try {
      return Json::parse(text);
    } catch (const Json::exception& error) {
      throw FileError(std::string("The view settings are no JSON: ") + error.what());
    }
  }

  double finite(double value) const {
    if (!std::isfinite(value))
      throw FileError("\"" + current_->name + "\" has a number that is not finite.");
    return value;
  }

  Json vector(const Vec3& v) const { return {finite(v.x), finite(v.y), finite(v.z)}; }

  Json points(const std::vector<Vec2>& points) const {
    Json made = Json::array();
    for (const Vec2& p : points) made.push_back(Json::array({finite(p.x), finite(p.y)}));
    return made;
  }

  Json node(const Node& node) {
    current_ = &node;
    Json made;
    made["id"] = node.id;
    made["name"] = node.name;
    if (!node.visible) made["visible"] = false;
    if (node.colour) {
      made["colour"] = Json::array();
      for (const float part : *node.colour) made["colour"].push_back(finite(double{part}));
    }
    made["position"] = vector(node.placement.position);
    if (node.placement.remainder != Vec3{0, 0, 0})
      made["remainder"] = vector(node.placement.remainder);
    made["rotation"] = vector(node.placement.rotation);
    made["scale"] = vector(node.placement.scale);
    std::visit([&](const auto& what) { add(what, made); }, node.what);
    if (!node.children.empty()) made["children"] = node.children;
    return made;
  }

  void add(const Primitive& p, Json& made) const {
    made["primitive"] = p.kind->name;
    made["size"] = vector(p.size);
    made["radius"] = finite(p.radius);
    made["top_radius"] = finite(p.top_radius);
    made["minor_radius"] = finite(p.minor_radius);
    made["height"] = finite(p.height);
    made["segments"] = p.segments;
    made["rings"] = p.rings;
    if (!p.profile.outer.empty()) made["outline"] = points(p.profile.outer);
    for (const std::vector<Vec2>& hole : p.profile.holes) made["holes"].push_back(points(hole));
  }

  void add(const Imported& imported, Json& made) {
    if (!imported.mesh) throw FileError("\"" + current_->name + "\" has no mesh.");
    made["imported"] = std::string(reinterpret_cast<const char*>(imported.path.u8string().c_str()));
    const auto [place, is_new] = numbers_.try_emplace(imported.mesh.get(), meshes_.size());
    if (is_new) meshes_.push_back(imported.mesh);
    made["mesh"] = place->second;
  }

  void add(const BooleanNode& operation, Json& made) const {
    made["operation"] = operation_names[static_cast<std::size_t>(operation.operation)];
  }

  void add(const SplitNode& split, Json& made) const {
    const HalfSpace& plane = split.plane;
    made["split"] = {finite(plane.a), finite(plane.b), finite(plane.c), finite(plane.d)};
    made["above"] = split.above;
  }

  void add(const Group&, Json& made) const { made["group"] = true; }

  void add(const Pattern& p, Json& made) const {
    made["pattern"] = pattern_names[static_cast<std::size_t>(p.kind)];
    made["count"] = p.count;
    made["step"] = vector(p.step);
    made["centre"] = vector(p.centre);
    made["axis"] = vector(p.axis);
    made["degrees"] = finite(p.degrees);
    made["path"] = Json::array();
    for (const Vec3& corner : p.path) made["path"].push_back(vector(corner));
    made["turns"] = p.turns;
    made["keeps"] = p.keeps;
  }

  const NameOfMesh& name_of_;
  const Node* current_ = nullptr;
  std::vector<MeshPointer> meshes_;
  std::map<const PolygonMesh*, std::size_t> numbers_;
};

template <class Number>
void append(std::string& text, Number number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  text.append(buffer, end);
}

void append(std::string& text, const std::vector<std::uint32_t>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ',';
    append(text, numbers[i]);
  }
}

}  // namespace

std::string mesh_text(const PolygonMesh& mesh, const std::string& name) {
  std::string text = "{\"positions\":[";
  text.reserve(60 * mesh.positions.size() + 8 * mesh.indices.size());
  for (const Vec3& p : mesh.positions) {
    for (const double x : {p.x, p.y, p.z}) {
      if (!std::isfinite(x)) throw FileError(name + " has a coordinate that is not finite.");
      if (text.back() != '[') text += ',';
      append(text, x);
      // "-0" would be read as the integer 0.
      if (x == 0 && std::signbit(x)) text += ".0";
    }
  }
  text += "],\"face_sizes\":[";
  append(text, mesh.face_sizes);
  text += "],\"indices\":[";
  append(text, mesh.indices);
  return text += "]}";
}

std::string scene_text(const SceneDocument& document, const NameOfMesh& name_of) {
  try {
    return SceneWriter(name_of).write(document);
  } catch (const Json::exception& error) {
    throw FileError(std::string("A name cannot be written: ") + error.what());
  }
}

std::string scene_text(const SceneDocument& document) {
  return scene_text(document, {});
}

void write_scene(const std::filesystem::path& path, const SceneDocument& document) {
  std::string text;
  try {
    text = scene_text(document);
  } catch (const FileError& error) {
    throw FileError(path.string() + ": " + error.what());
  }
  write_whole(path, text);
}

}  // namespace sectile::viewer
