// Drawing profiles: the corners, the loops, what is wrong with them.
#include "scene/profile_sketch.h"

#include <gtest/gtest.h>

#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

void expect_at(const Vec2& p, double x, double y) {
  EXPECT_EQ(p.x, x);
  EXPECT_EQ(p.y, y);
}

Primitive extrusion() {
  Primitive primitive;
  primitive.kind = &primitive_kind("extrusion");
  primitive.height = 1;
  return primitive;
}

TEST(ProfileSketches, DrawsALoopAndAHole) {
  ProfileSketch sketch;
  EXPECT_NE(sketch.problem(extrusion()), "");
  for (const Vec2& p : {Vec2{0, 0}, {4, 0}, {4, 4}, {0, 4}}) sketch.add_corner(p);
  sketch.add_corner({0, 4});  // a double click
  EXPECT_EQ(sketch.drawn().size(), 4u);
  EXPECT_NE(sketch.problem(extrusion()).find("Close"), std::string::npos);
  EXPECT_TRUE(sketch.close());
  EXPECT_EQ(sketch.problem(extrusion()), "");
  sketch.add_loop(rectangle_loop({2, 2}, 1, 1));
  Primitive made = extrusion();
  made.profile = sketch.profile();
  EXPECT_EQ(made.profile.holes.size(), 1u);
  EXPECT_EQ(solid_of(made).volume(), 15);
}

TEST(ProfileSketches, TheLargestLoopIsTheOuterOne) {
  ProfileSketch sketch;
  sketch.add_loop(rectangle_loop({0, 0}, 1, 1));
  sketch.add_loop(rectangle_loop({0, 0}, 3, 3));
  EXPECT_EQ(sketch.profile().outer[0].x, -1.5);
  EXPECT_EQ(sketch.problem(extrusion()), "");
}

TEST(ProfileSketches, SidesByLengthAndAngle) {
  const SketchSide side = side_between({1, 1}, {1, 4});
  EXPECT_EQ(side.length, 3);
  EXPECT_EQ(side.degrees, 90);
  expect_at(end_of({1, 1}, {3, 90}), 1, 4);
  expect_at(end_of({1, 1}, {2.5, 180}), -1.5, 1);
  EXPECT_NEAR(end_of({0, 0}, {2, 30}).y, 1, 1e-15);
}

TEST(ProfileSketches, UndoGoesBackStepByStep) {
  ProfileSketch sketch;
  sketch.add_loop(rectangle_loop({0, 0}, 2, 2));
  sketch.begin_move();
  for (int i = 0; i < 5; ++i) sketch.move({0, 0}, {-2.0 - i, -1});
  sketch.end_move();
  expect_at(sketch.at({0, 0}), -6, -1);
  sketch.insert_before({0, 1}, {0, -1});
  EXPECT_EQ(sketch.loops()[0].size(), 5u);
  sketch.remove({0, 3});
  sketch.undo();
  sketch.undo();
  expect_at(sketch.at({0, 0}), -6, -1);
  sketch.undo();
  expect_at(sketch.at({0, 0}), -1, -1);
  sketch.undo();
  EXPECT_TRUE(sketch.loops().empty());
  EXPECT_FALSE(sketch.can_undo());
}

TEST(ProfileSketches, ATriangleGoesAsAWhole) {
  ProfileSketch sketch;
  sketch.add_loop({{0, 0}, {1, 0}, {0, 1}});
  sketch.remove({0, 1});
  EXPECT_TRUE(sketch.loops().empty());
}

TEST(ProfileSketches, CrossingOutlinesAreSaid) {
  ProfileSketch sketch;
  sketch.add_loop({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_NE(sketch.problem(extrusion()), "");
}

TEST(ProfileSketches, PlanesAcrossAxesAreExact) {
  for (const Vec3& n : {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    const Vec3 point{0.3, 0.7, 1.1};
    const Transform map = placement_on_plane(point, n).transform();
    const Vec3 origin = map({0, 0, 0}), up = map({0, 0, 1});
    EXPECT_EQ(origin.x, n.x == 0 ? 0 : 0.3);
    EXPECT_EQ(origin.y, n.y == 0 ? 0 : 0.7);
    EXPECT_EQ(origin.z, n.z == 0 ? 0 : 1.1);
    EXPECT_EQ(up, (Vec3{origin.x + n.x, origin.y + n.y, origin.z + n.z}));
  }
  const Transform slanted = placement_on_plane({1, 1, 1}, {0.6, 0, 0.8}).transform();
  const Vec3 p = slanted({5, -3, 0});
  EXPECT_NEAR(0.6 * p.x + 0.8 * p.z, 1.4, 1e-12);
}

}  // namespace
}  // namespace sectile::viewer
