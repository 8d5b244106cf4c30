#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "scene/primitive_kind.h"
#include "scene/scene_file.h"
#include "scene/scene_json.h"

namespace sectile::viewer {

namespace {

using Json = nlohmann::ordered_json;

/// A value of the file together with the way to it, for messages.
struct Place {
  const Json& json;
  std::string way;

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError((way.empty() ? "the file" : way) + " " + what);
  }
  bool has(const char* key) const { return json.contains(key); }
  Place operator[](const char* key) const {
    if (!json.is_object()) fail("is not an object");
    const auto found = json.find(key);
    if (found == json.end()) fail(std::string("has no \"") + key + "\"");
    return {*found, way + "/" + key};
  }
  Place operator[](std::size_t i) const { return {json[i], way + "/" + std::to_string(i)}; }
  std::size_t list_size() const {
    if (!json.is_array()) fail("is not a list");
    return json.size();
  }
  double number() const {
    if (!json.is_number()) fail("is not a number");
    return json.get<double>();
  }
  std::uint32_t count() const {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > UINT32_MAX)
      fail("is not a whole number from 0 to 4294967295");
    return json.get<std::uint32_t>();
  }
  bool flag() const {
    if (!json.is_boolean()) fail("is neither true nor false");
    return json.get<bool>();
  }
  std::string text() const {
    if (!json.is_string()) fail("is not a text");
    return json.get<std::string>();
  }
  std::vector<std::uint32_t> counts() const {
    std::vector<std::uint32_t> made(list_size());
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = json[i].is_number_unsigned() && json[i].get<std::uint64_t>() <= UINT32_MAX
                    ? json[i].get<std::uint32_t>()
                    : (*this)[i].count();  // which says what is wrong with it
    return made;
  }
  std::vector<double> numbers(std::size_t wanted) const {
    if (list_size() != wanted) fail("does not have " + std::to_string(wanted) + " numbers");
    std::vector<double> made;
    for (std::size_t i = 0; i < wanted; ++i) made.push_back((*this)[i].number());
    return made;
  }
  Vec3 vector() const {
    const std::vector<double> n = numbers(3);
    return {n[0], n[1], n[2]};
  }
  std::vector<Vec2> points() const {
    std::vector<Vec2> made;
    for (std::size_t i = 0; i < list_size(); ++i) {
      const std::vector<double> n = (*this)[i].numbers(2);
      made.push_back({n[0], n[1]});
    }
    return made;
  }
  template <std::size_t Count>
  std::size_t one_of(const std::array<std::string_view, Count>& names) const {
    const std::string wanted = text();
    for (std::size_t i = 0; i < Count; ++i)
      if (names[i] == wanted) return i;
    fail_unknown();
  }
  [[noreturn]] void fail_unknown() const {
    fail("is \"" + text() + "\", which this version does not know");
  }
};

MeshPointer mesh_at(const Place& place) {
  auto mesh = std::make_shared<PolygonMesh>();
  const Place positions = place["positions"];
  if (positions.list_size() % 3 != 0) positions.fail("does not have three numbers for each point");
  mesh->positions.resize(positions.json.size() / 3);
  for (std::size_t i = 0; i < positions.json.size(); ++i) {
    const Json& json = positions.json[i];
    const double x = json.is_number() ? json.get<double>() : positions[i].number();
    Vec3& p = mesh->positions[i / 3];
    (i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z) = x;
  }
  mesh->face_sizes = place["face_sizes"].counts();
  mesh->indices = place["indices"].counts();
  return mesh;
}

Primitive primitive_at(const Place& place) {
  Primitive p;
  const std::span kinds = primitive_kinds();
  const Place named = place["primitive"];
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [name = named.text()](const auto* k) { return k->name == name; });
  if (kind == kinds.end()) named.fail_unknown();
  p.kind = *kind;
  p.size = place["size"].vector();
  p.radius = place["radius"].number();
  p.top_radius = place["top_radius"].number();
  p.minor_radius = place["minor_radius"].number();
  p.height = place["height"].number();
  p.segments = place["segments"].count();
  p.rings = place["rings"].count();
  if (place.has("outline")) p.profile.outer = place["outline"].points();
  if (place.has("holes"))
    for (std::size_t i = 0; i < place["holes"].list_size(); ++i)
      p.profile.holes.push_back(place["holes"][i].points());
  return p;
}

SplitNode split_at(const Place& place) {
  const std::vector<double> n = place["split"].numbers(4);
  return {{n[0], n[1], n[2], n[3]}, place["above"].flag()};
}

Pattern pattern_at(const Place& place) {
  Pattern p;
  p.kind = static_cast<Pattern::Kind>(place["pattern"].one_of(pattern_names));
  p.count = place["count"].count();
  p.step = place["step"].vector();
  p.centre = place["centre"].vector();
  p.axis = place["axis"].vector();
  p.degrees = place["degrees"].number();
  const Place path = place["path"];
  for (std::size_t i = 0; i < path.list_size(); ++i) p.path.push_back(path[i].vector());
  p.turns = place["turns"].flag();
  p.keeps = place["keeps"].flag();
  return p;
}

void read_what(const Place& place, const std::vector<MeshPointer>& meshes, Node& node) {
  if (place.has("primitive")) {
    node.what = primitive_at(place);
  } else if (place.has("imported")) {
    const std::uint32_t mesh = place["mesh"].count();
    if (mesh >= meshes.size()) place["mesh"].fail("is not the number of a mesh of the file");
    const std::string path = place["imported"].text();
    node.what = Imported{std::u8string(path.begin(), path.end()), meshes[mesh]};
  } else if (place.has("operation")) {
    node.what = BooleanNode{static_cast<Operation>(place["operation"].one_of(operation_names))};
  } else if (place.has("split")) {
    node.what = split_at(place);
  } else if (place.has("pattern")) {
    node.what = pattern_at(place);
  } else if (place.has("group")) {
    node.what = Group();
  } else {
    place.fail("is of a kind that this version does not know");
  }
}

Node node_at(const Place& place, const std::vector<MeshPointer>& meshes) {
  Node node;
  node.id = place["id"].count();
  node.name = place["name"].text();
  if (place.has("visible")) node.visible = place["visible"].flag();
  if (place.has("colour")) {
    const std::vector<double> parts = place["colour"].numbers(3);
    NodeColour colour{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(parts[i] >= 0 && parts[i] <= 1))
        place["colour"].fail("is not three numbers from 0 to 1");
      colour[i] = static_cast<float>(parts[i]);
    }
    node.colour = colour;
  }
  node.placement.position = place["position"].vector();
  if (place.has("remainder")) node.placement.remainder = place["remainder"].vector();
  node.placement.rotation = place["rotation"].vector();
  node.placement.scale = place["scale"].vector();
  read_what(place, meshes, node);
  if (place.has("children")) node.children = place["children"].counts();
  return node;
}

std::vector<MeshPointer> meshes_at(const Place& place, const MeshOfName& mesh_of) {
  std::vector<MeshPointer> made;
  for (std::size_t i = 0; i < place.list_size(); ++i) {
    const Place mesh = place[i];
    if (mesh_of && mesh.has("file"))
      made.push_back(mesh_of(mesh["file"].text()));
    else
      made.push_back(mesh_at(mesh));
  }
  return made;
}

void link_parents(std::vector<Node>& nodes) {
  std::map<NodeId, NodeId> parents;
  for (const Node& node : nodes)
    for (const NodeId child : node.children) parents[child] = node.id;
  for (Node& node : nodes)
    if (const auto found = parents.find(node.id); found != parents.end())
      node.parent = found->second;
}

void check_children(const Node& node, const Place& place) {
  const std::size_t most = std::holds_alternative<SplitNode>(node.what)   ? 1
                           : std::holds_alternative<Primitive>(node.what) ? 0
                           : std::holds_alternative<Imported>(node.what)  ? 0
                                                                          : SIZE_MAX;
  if (node.children.size() > most) place["children"].fail("has too many entries for its kind");
}

SceneDocument document_at(const Place& file, const MeshOfName& mesh_of) {
  if (!file.json.is_object() || !file.has("kind") || file["kind"].text() != scene_file_kind)
    file.fail("is not a scene of Sectile");
  if (const std::uint32_t version = file["version"].count(); version != scene_file_version)
    file["version"].fail("is " + std::to_string(version) + "; this version reads " +
                         std::to_string(scene_file_version) + ". A newer Sectile may read it");
  SceneDocument made;
  if (file.has("view")) made.view = file["view"].json.dump();
  const std::vector<MeshPointer> meshes = meshes_at(file["meshes"], mesh_of);
  std::vector<Node> nodes;
  const Place list = file["nodes"];
  for (std::size_t i = 0; i < list.list_size(); ++i) {
    nodes.push_back(node_at(list[i], meshes));
    check_children(nodes.back(), list[i]);
  }
  link_parents(nodes);
  try {
    made.scene = Scene::from_nodes(std::move(nodes), file["roots"].counts());
  } catch (const std::invalid_argument& error) {
    list.fail(std::string("are wrong: ") + error.what());
  }
  return made;
}

template <class Read>
auto parsed(std::string_view text, const std::string& name, Read&& read) {
  try {
    const Json json = Json::parse(text);
    return read(Place{json, ""});
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(text.size(), error.byte == 0 ? 0 : error.byte - 1);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw FileError(name + ":" + std::to_string(line) +
                    ": this is no JSON, as scenes are: it ends too early or has a mark too many");
  } catch (const Json::exception&) {
    throw FileError(name + ": a value is of another kind than in a scene");
  } catch (const FileError& error) {
    throw FileError(name + ": " + error.what());
  }
}

}  // namespace

SceneDocument parse_scene(std::string_view text, const std::string& name,
                          const MeshOfName& mesh_of) {
  return parsed(text, name, [&](const Place& file) { return document_at(file, mesh_of); });
}

SceneDocument parse_scene(std::string_view text, const std::string& name) {
  return parse_scene(text, name, {});
}

MeshPointer parse_mesh(std::string_view text, const std::string& name) {
  return parsed(text, name, mesh_at);
}

bool is_scene_file(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".sectile" || extension == ".json";
}

SceneDocument read_scene(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || in.bad()) throw FileError(path.string() + ": the file cannot be read");
  return parse_scene(text.view(), path.string());
}

}  // namespace sectile::viewer
