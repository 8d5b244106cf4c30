#include "scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

Scene scene_of_everything() {
  Scene scene;
  std::vector<NodeId> ids;
  for (const PrimitiveKind* kind : primitive_kinds()) {
    Primitive p;
    p.kind = kind;
    p.size = {0.1, 1e-300, 1.0 / 3};
    p.profile = {{{0, 0}, {1, 0}, {0.5, 0.7}}, {{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.3}}}};
    Node node;
    node.what = p;
    node.placement = {{-0.0, 1e22, 5e-324}, {30, 0.1, -90}, {1, 2, -3}, {0, -0x1p-1, 0x1.8p-60}};
    node.visible = kind->name != "pyramid";
    ids.push_back(scene.add(node));
  }
  auto mesh = std::make_shared<PolygonMesh>();
  mesh->positions = {{0.1, -0.0, 1e17},
                     {1.0 / 3, 2, std::numeric_limits<double>::max()},
                     {5e-324, 9007199254740993.0, -7}};
  mesh->face_sizes = {3};
  mesh->indices = {0, 1, 2};
  Node imported;
  imported.what = Imported{"folder/Würfel \"2\".obj", mesh};
  const NodeId first = scene.add(imported);
  scene.duplicate(first);
  scene.combine({ids[0], ids[1]}, Operation::intersect);
  scene.group({ids[2], ids[3], first});
  scene.split(ids[4], {1, 0.1, 0.25, -0.3});
  scene.remove(ids[5]);
  return scene;
}

std::string message_of(const std::string& text) {
  try {
    parse_scene(text, "some.sectile");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SceneFile, EverythingComesBackAsItWas) {
  const Scene scene = scene_of_everything();
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "everything.sectile";
  write_scene(path, {scene, R"({"camera":{"distance":0.1},"theme":"dark"})"});
  const SceneDocument back = read_scene(path);
  std::filesystem::remove(path);
  EXPECT_TRUE(back.scene == scene);
  EXPECT_EQ(back.view, R"({"camera":{"distance":0.1},"theme":"dark"})");
  // == takes both zeros for the same.
  for (const NodeId id : back.scene.in_order()) {
    const auto* imported = std::get_if<Imported>(&back.scene.at(id).what);
    if (!imported) continue;
    EXPECT_TRUE(std::signbit(imported->mesh->positions[0].y));
  }
  EXPECT_TRUE(std::signbit(back.scene.at(1).placement.position.x));
}

TEST(SceneFile, AMeshUsedTwiceIsWrittenOnce) {
  const std::string text = scene_text({scene_of_everything(), ""});
  EXPECT_EQ(text.find("face_sizes"), text.rfind("face_sizes"));
  const Scene back = parse_scene(text, "x").scene;
  std::vector<MeshPointer> meshes;
  for (const NodeId id : back.in_order())
    if (const auto* imported = std::get_if<Imported>(&back.at(id).what))
      meshes.push_back(imported->mesh);
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0], meshes[1]);
}

TEST(SceneFile, EmptySceneComesBack) {
  EXPECT_TRUE(parse_scene(scene_text({}), "x").scene == Scene());
}

TEST(SceneFile, NewNodesGetIdsThatWereNotUsed) {
  Scene scene = scene_of_everything();
  Scene back = parse_scene(scene_text({scene, ""}), "x").scene;
  Node node;
  const NodeId id = back.add(node);
  EXPECT_EQ(scene.find(id), nullptr);
}

TEST(SceneFile, ErrorsSayFileWhatAndWhere) {
  EXPECT_EQ(
      message_of("{\n not json"),
      "some.sectile:2: this is no JSON, as scenes are: it ends too early or has a mark too many");
  EXPECT_NE(message_of("[1, 2]").find("not a scene"), std::string::npos);
  std::string text = scene_text({scene_of_everything(), ""});
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    return message_of(changed.replace(changed.find(from), from.size(), to));
  };
  EXPECT_EQ(with("\"version\": 1", "\"version\": 99"),
            "some.sectile: /version is 99; this version reads 1. A newer Sectile may read it");
  EXPECT_EQ(with("\"radius\": 1.0", "\"radius\": \"big\""),
            "some.sectile: /nodes/1/radius is not a number");
  EXPECT_EQ(with("\"primitive\": \"block\"", "\"primitive\": \"blob\""),
            "some.sectile: /nodes/1/primitive is \"blob\", which this version does not know");
  EXPECT_NE(with("\"id\": 1,", "\"id\": 2,").find("ids must be different"), std::string::npos);
  EXPECT_NE(with("\"children\": [\n    1,", "\"children\": [\n    44,").find("/nodes are wrong"),
            std::string::npos);
  for (std::size_t end = 0; end < text.size() - 2; end += 97)
    EXPECT_NE(message_of(text.substr(0, end)), "no error") << end;
}

TEST(SceneFile, WhatCannotBeWrittenLeavesTheOldFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "kept.sectile";
  const Scene scene = scene_of_everything();
  write_scene(path, {scene, ""});
  Scene bad = scene;
  bad.edit(1).placement.position.x = NAN;
  EXPECT_THROW(write_scene(path, {bad, ""}), FileError);
  EXPECT_TRUE(read_scene(path).scene == scene);
  std::filesystem::remove(path);
  EXPECT_THROW(read_scene(path), FileError);
  EXPECT_THROW(write_scene(std::filesystem::path("/no/such/folder/x"), {scene, ""}), FileError);
}

}  // namespace
}  // namespace sectile::viewer
