// Parts of scenes as texts.
#include "scene/scene_clip.h"

#include <gtest/gtest.h>

#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

Scene two_blocks_united() {
  Scene scene;
  Node block;
  block.what = Primitive();
  block.name = "Base";
  const NodeId a = scene.add(block);
  block.name = "Knob";
  block.placement.position = {0.1, 0.2, 0.3};
  const NodeId b = scene.add(block);
  scene.combine({a, b}, Operation::unite);
  return scene;
}

TEST(SceneClip, WholeSubtreesGoIntoAnotherScene) {
  const Scene from = two_blocks_united();
  Scene to;
  Node block;
  block.what = Primitive();
  block.name = "Base";
  to.add(block);
  const auto made = insert(to, copied_scene(copied_text(from, from.roots())));
  ASSERT_EQ(made.size(), 1u);
  ASSERT_EQ(to.size(), 4u);
  const Node& united = to.at(made.front());
  EXPECT_EQ(std::get<BooleanNode>(united.what).operation, Operation::unite);
  EXPECT_EQ(to.at(united.children[0]).name, "Base 2") << "names stay different";
  EXPECT_EQ(to.at(united.children[1]).placement.position, (Vec3{0.1, 0.2, 0.3}));
}

TEST(SceneClip, AnOperandStaysWhereItIsInTheWorld) {
  Scene from = two_blocks_united();
  const NodeId top = from.roots().front(), knob = from.at(top).children[1];
  from.edit(top).placement.position = {10, 20, 30};
  const Scene clip = copied_scene(copied_text(from, {knob}));
  ASSERT_EQ(clip.roots().size(), 1u);
  EXPECT_EQ(clip.at(clip.roots().front()).placement.position, (Vec3{10.1, 20.2, 30.3}));
}

TEST(SceneClip, OtherTextsAreRefused) {
  EXPECT_THROW(copied_scene("hello"), FileError);
  EXPECT_THROW(copied_scene("{}"), FileError);
}

}  // namespace
}  // namespace sectile::viewer
