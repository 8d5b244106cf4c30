// Moving pictures are cheap, and full quality comes soon: counted in work and in frames of a fixed
// length, as times differ from machine to machine (bench/viewer_bench.cpp measures them).
#include <gtest/gtest.h>

#include "scene/primitive_kind.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

constexpr std::uint64_t triangles = 2 * 320 * 156;  // of the ball

Scene scene_of_a_dense_ball() {
  Primitive ball = first_primitive(primitive_kind("sphere"));
  ball.segments = 320;
  ball.rings = 157;
  Scene scene;
  Node node;
  node.what = ball;
  scene.add(node);
  return scene;
}

class Rest : public testing::Test {
 protected:
  Rest() : driver_(AppOptions(), 640, 400) {
    driver_.app().start(scene_of_a_dense_ball(), {});
    do driver_.settle(1);
    while (driver_.app().needs_frame() || driver_.scene().is_empty());
  }
  /// What the frames of something draw.
  template <class Frames>
  DrawnWork work_of(const Frames& frames) {
    const DrawnWork before = driver_.app().drawn();
    frames();
    const DrawnWork after = driver_.app().drawn();
    return {after.pictures - before.pictures, after.samples - before.samples,
            after.triangles - before.triangles};
  }
  std::uint64_t pixels() {
    const glm::vec4 picture = driver_.app().widget("picture");
    return static_cast<std::uint64_t>(picture.z * picture.w);
  }
  glm::dvec2 beside_the_ball() {
    const glm::vec4 picture = driver_.app().widget("picture");
    return {picture.x + picture.z - 60, picture.y + picture.w / 2};
  }

  AppDriver driver_;
};

TEST_F(Rest, MovingPicturesDrawEachTriangleOnceAndEachPixelOnce) {
  ASSERT_GT(driver_.session().results.evaluation()->nodes.size(), 0u);
  const glm::dvec2 from = beside_the_ball();
  const Camera before = driver_.app().camera();
  const DrawnWork work = work_of([&] { driver_.hold(from, from + glm::dvec2(30, 6)); });
  ASSERT_NE(driver_.app().camera().azimuth, before.azimuth) << "it turns";
  ASSERT_GE(work.pictures, 3u);
  EXPECT_LE(work.triangles, work.pictures * (triangles + triangles / 10));
  EXPECT_LE(work.samples, work.pictures * (pixels() + pixels() / 50));
}

TEST_F(Rest, MovingPicturesOfAResultDrawItsTrianglesOnce) {
  driver_.add("block");
  driver_.key('A', true);
  driver_.key('D');
  do driver_.settle(1);
  while (driver_.app().needs_frame());
  const Solid* result = driver_.session().results.solid(driver_.scene().roots().front());
  ASSERT_TRUE(result && !result->is_empty());
  const std::uint64_t drawn = result->to_mesh().face_sizes.size();
  const glm::dvec2 from = beside_the_ball();
  driver_.move(from);
  driver_.settle(2);
  const DrawnWork work = work_of([&] { driver_.hold(from, from + glm::dvec2(30, 6)); });
  ASSERT_GE(work.pictures, 3u);
  EXPECT_LE(work.triangles, work.pictures * (drawn + triangles / 10))
      << "neither the tint of what is removed nor the outline of an operand";
}

TEST_F(Rest, FullQualityComesWithinHalfASecond) {
  const glm::dvec2 from = beside_the_ball();
  driver_.hold(from, from + glm::dvec2(30, 6));
  int frames = 4;  // of letting go
  const DrawnWork work = work_of([&] {
    driver_.let_go(from + glm::dvec2(30, 6));
    do driver_.settle(1), ++frames;
    while (driver_.app().needs_frame() && frames < 100);
  });
  EXPECT_LE(frames, 30) << "of a sixtieth of a second";
  // One picture, in which the triangles are drawn for light, shadow and outline only.
  EXPECT_EQ(work.pictures, 1u);
  EXPECT_GE(work.samples, 3 * pixels());
  EXPECT_LE(work.triangles, 3 * triangles);
  // And then nothing until something moves.
  EXPECT_EQ(work_of([&] { driver_.settle(20); }).pictures, 0u);
}

TEST_F(Rest, NothingIsDrawnWhileOnlyTheMouseMovesOverPanels) {
  driver_.press("tree:" + std::to_string(driver_.scene().roots().front()));
  ASSERT_NE(driver_.session().selected(), 0u) << "with handles in the picture";
  do driver_.settle(1);
  while (driver_.app().needs_frame());
  const DrawnWork work = work_of([&] {
    for (const char* place : {"view.frame", "tool.add", "properties.position.x"}) {
      driver_.move(driver_.middle(place));
      driver_.settle(2);
    }
  });
  EXPECT_EQ(work.pictures, 0u);
}

TEST(WithoutAWindow, OnlyFramesThatAreAskedForAreDrawn) {
  AppDriver driver(AppDriver::waiting(), 640, 400);
  App& app = driver.app();
  app.start(scene_of_a_dense_ball(), {});
  const std::uint64_t before = app.drawn().pictures;
  for (int i = 0; i < 3; ++i) app.frame({}, 0.1);
  EXPECT_EQ(app.drawn().pictures, before);
  const Image shown = app.screenshot();
  EXPECT_EQ(app.drawn().pictures, before + 1);
  app.frame({}, 0.1);
  EXPECT_EQ(app.screenshot().rgba, shown.rgba);
}

}  // namespace
}  // namespace sectile::viewer
