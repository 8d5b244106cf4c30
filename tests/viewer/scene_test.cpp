#include "scene/scene.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/primitive_kind.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

Node block_at(double x) {
  Node node;
  node.what = Primitive();
  node.placement.position.x = x;
  return node;
}

using Ids = std::vector<NodeId>;

TEST(Scene, GivesReadableNamesThatAreFree) {
  Scene scene;
  const NodeId first = scene.add(block_at(0)), second = scene.add(block_at(1));
  EXPECT_EQ(scene.at(first).name, "Block");
  EXPECT_EQ(scene.at(second).name, "Block 2");
  EXPECT_EQ(scene.at(scene.duplicate(second)).name, "Block 3");
  scene.rename(second, "Lid");
  EXPECT_EQ(scene.at(scene.add(block_at(2))).name, "Block 2");
  scene.rename(first, "Lid");
  EXPECT_EQ(scene.at(first).name, "Lid 2");
}

TEST(Scene, EditsOneOfTwoCopiesOnly) {
  Scene scene;
  const NodeId id = scene.add(block_at(0));
  Scene copy = scene;
  copy.edit(id).placement.position.x = 5;
  EXPECT_EQ(scene.at(id).placement.position.x, 0);
  EXPECT_EQ(copy.at(id).placement.position.x, 5);
  EXPECT_FALSE(scene == copy);
  copy.edit(id).placement.position.x = 0;
  EXPECT_TRUE(scene == copy);
}

TEST(Scene, CombinesInThePlaceOfTheFirst) {
  Scene scene;
  const NodeId a = scene.add(block_at(0)), b = scene.add(block_at(1)), c = scene.add(block_at(2));
  const NodeId made = scene.combine({b, c}, Operation::subtract);
  EXPECT_EQ(scene.roots(), (Ids{a, made}));
  EXPECT_EQ(scene.at(made).children, (Ids{b, c}));
  EXPECT_EQ(scene.at(made).name, "Difference");
  EXPECT_EQ(scene.in_order(), (Ids{a, made, b, c}));
  EXPECT_THROW(scene.combine({made, b}, Operation::unite), std::invalid_argument);
}

TEST(Scene, RefusesWhatWouldBeNoTree) {
  Scene scene;
  const NodeId a = scene.add(block_at(0)), b = scene.add(block_at(1));
  const NodeId group = scene.group({a, b});
  EXPECT_THROW(scene.move(group, group), std::invalid_argument);
  EXPECT_THROW(scene.move(group, a), std::invalid_argument);
  EXPECT_THROW(scene.add(block_at(0), a), std::invalid_argument);
  EXPECT_THROW(scene.edit(77), std::out_of_range);
  EXPECT_THROW(scene.group({}), std::invalid_argument);
}

TEST(Scene, RemovesAndDuplicatesWholeSubtrees) {
  Scene scene;
  const NodeId a = scene.add(block_at(0)), b = scene.add(block_at(1));
  const NodeId made = scene.combine({a, b}, Operation::unite);
  const NodeId copy = scene.duplicate(made);
  EXPECT_EQ(scene.size(), 6u);
  EXPECT_EQ(scene.at(copy).children.size(), 2u);
  EXPECT_EQ(scene.at(scene.at(copy).children[1]).placement.position.x, 1);
  scene.remove(made);
  EXPECT_EQ(scene.size(), 3u);
  EXPECT_EQ(scene.roots(), (Ids{copy}));
  EXPECT_EQ(scene.find(a), nullptr);
}

TEST(Scene, KeepsWorldPlacesWhenNodesMoveInTheTree) {
  Scene scene;
  const NodeId a = scene.add(block_at(3)), b = scene.add(block_at(7));
  const NodeId group = scene.group({a});
  scene.edit(group).placement = {{1, 2, 3}, {0, 0, 90}, {2, 2, 2}};
  scene.move(b, group);
  EXPECT_NEAR(scene.world(b)({0, 0, 0}).x, 7, 1e-14);
  EXPECT_NEAR(scene.world(b)({1, 0, 0}).x, 8, 1e-14);
  EXPECT_EQ(scene.world(a)({0, 0, 0}), (Vec3{1, 8, 3}));
  scene.ungroup(group);
  EXPECT_EQ(scene.roots(), (Ids{a, b}));
  EXPECT_EQ(scene.world(a)({0, 0, 0}), (Vec3{1, 8, 3}));
  EXPECT_EQ(scene.at(a).placement, (Placement{{1, 8, 3}, {0, 0, 90}, {2, 2, 2}}));
}

TEST(Scene, NodesThatChangeTheirParentStayExactlyWhereTheyAre) {
  Scene scene;
  const NodeId a = scene.add(block_at(0.2)), b = scene.add(block_at(1.0 / 3));
  const NodeId group = scene.group({a});
  scene.edit(group).placement = {{0.1, 1e9, 0}, {0, 0, 90}, {1, 1, 1}};
  const ExactTransform of_a = scene.exact_world(a), of_b = scene.exact_world(b);
  scene.move(b, group);
  EXPECT_EQ(scene.exact_world(b), of_b);
  scene.ungroup(group);
  EXPECT_EQ(scene.exact_world(a), of_a);
  EXPECT_EQ(scene.exact_world(b), of_b);
}

TEST(Scene, SplitsIntoTwoPartsInTheSamePlace) {
  Scene scene;
  const NodeId a = scene.add(block_at(0)), b = scene.add(block_at(9));
  const auto [above, below] = scene.split(a, {0, 0, 1, -0.5});
  EXPECT_EQ(scene.roots(), (Ids{above, below, b}));
  EXPECT_EQ(scene.at(above).children, (Ids{a}));
  EXPECT_EQ(scene.at(above).name, "Block above");
  EXPECT_TRUE(std::get<SplitNode>(scene.at(above).what).above);
  EXPECT_FALSE(std::get<SplitNode>(scene.at(below).what).above);
  EXPECT_THROW(scene.duplicate(a), std::invalid_argument);
  EXPECT_EQ(scene.at(scene.group({a})).parent, above);
  EXPECT_THROW(scene.split(b, {0, 0, 0, 1}), std::invalid_argument);
}

TEST(Scene, PlanesOfCutsAreThoseOfTheWorld) {
  Scene scene;
  const NodeId a = scene.add(block_at(0)), group = scene.group({a});
  scene.edit(group).placement = {{0, 0, 10}, {90, 0, 0}, {1, 1, 1}};
  const NodeId above = scene.split(a, {0, 0, 1, -10.5}).first;  // world z >= 10.5
  const HalfSpace& plane = std::get<SplitNode>(scene.at(above).what).plane;
  EXPECT_EQ(plane.a, 0);
  EXPECT_EQ(plane.b, 1);
  EXPECT_EQ(plane.c, 0);
  EXPECT_EQ(plane.d, -0.5);
}

TEST(Placement, IsExactForRightAnglesAndDoubles) {
  const Placement placement{{0.1, 0.2, 0.3}, {90, 0, 180}, {2, 1, 0.5}};
  EXPECT_EQ(placement.transform()({1, 1, 1}), (Vec3{-2 + 0.1, 0.5 + 0.2, 1 + 0.3}));
}

TEST(Placement, ComesBackFromItsMap) {
  for (const Vec3 rotation : {Vec3{0, 0, 0}, Vec3{90, 0, 0}, Vec3{15, -30, 45}, Vec3{0, 90, 30},
                              Vec3{-170, 80, 5}, Vec3{0, -90, 0}}) {
    const Placement placement{{1, 2, 3}, rotation, {1, 2, 0.5}};
    const Placement back = Placement::of(placement.transform());
    EXPECT_EQ(back.rotation, rotation) << rotation.x << " " << rotation.y << " " << rotation.z;
    EXPECT_EQ(back.scale, placement.scale);
    EXPECT_EQ(back.position, placement.position);
  }
}

TEST(Primitives, AreCentredAndRefuseBadParameters) {
  Primitive p;
  for (const PrimitiveKind* kind : primitive_kinds()) {
    if (kind->profile != ProfileUse::none) continue;
    p = first_primitive(*kind);
    const Solid solid = solid_of(p);
    EXPECT_GT(solid.volume(), 0);
    double low = 0, high = 0;
    for (const Vec3& v : solid.to_mesh().positions)
      low = std::min(low, v.z), high = std::max(high, v.z);
    EXPECT_EQ(low, -high);
    p.size.x = p.radius = 0;
    EXPECT_THROW(solid_of(p), std::invalid_argument) << kind->name;
  }
  p = Primitive();
  p.kind = &primitive_kind("sphere");
  p.segments = p.rings = 1'000'000;
  EXPECT_THROW(solid_of(p), std::invalid_argument);
}

}  // namespace
}  // namespace sectile::viewer
