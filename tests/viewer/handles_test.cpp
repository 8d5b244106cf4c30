#include "scene/handles.h"

#include <gtest/gtest.h>

#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

const glm::dvec2 size{800, 600};

struct HandlesTest : testing::Test {
  Camera camera;
  glm::dvec2 seen(const glm::dvec3& p) const { return glm::dvec2(camera.project(p, size)); }
  Ray ray(const glm::dvec3& through) const { return camera.ray(seen(through), size); }
  Handles handles(HandleMode mode, const Placement& placement = {}, bool local = false) const {
    return Handles::at(mode, placement.transform(), local, camera, size);
  }
};

TEST_F(HandlesTest, StayTheSameSizeOnTheScreen) {
  for (const double distance : {2.0, 8.0, 400.0}) {
    camera.distance = distance;
    const double pixels = handles(HandleMode::move).size / camera.pixel_length({0, 0, 0}, size);
    EXPECT_NEAR(pixels, 90, 1e-6);
  }
}

TEST_F(HandlesTest, FindsThePartUnderThePointer) {
  const Handles move = handles(HandleMode::move);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 tip = move.origin + 0.9 * move.size * move.axes[i];
    EXPECT_EQ(move.part_at(camera, seen(tip), size), static_cast<HandlePart>(i));
    const glm::dvec3 square =
        move.origin + 0.35 * move.size * (move.axes[(i + 1) % 3] + move.axes[(i + 2) % 3]);
    EXPECT_EQ(move.part_at(camera, seen(square), size), static_cast<HandlePart>(3 + i));
  }
  EXPECT_EQ(move.part_at(camera, seen({0, 0, 0}), size), HandlePart::centre);
  EXPECT_EQ(move.part_at(camera, {5, 5}, size), std::nullopt);
  const Handles rotate = handles(HandleMode::rotate);
  const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(glm::dvec2(camera.position()), 0));
  EXPECT_EQ(rotate.part_at(camera, seen(rotate.size * towards_eye), size), HandlePart::ring_z);
}

TEST_F(HandlesTest, DragsOfAxesAndPlanesFollowThePointer) {
  const Handles move = handles(HandleMode::move);
  HandleDrag axis(move, HandlePart::axis_x, ray({0.5, 0, 0}), camera);
  HandleChange change = axis.change(ray({1.75, 0, 0}));
  EXPECT_NEAR(change.move.x, 1.25, 1e-9);
  EXPECT_EQ(change.move.y, 0);
  EXPECT_EQ(change.move.z, 0);
  const Placement moved = changed({{1, 2, 3}, {0, 0, 0}, {1, 1, 1}}, {}, move, change);
  EXPECT_EQ(moved.position.y, 2);
  EXPECT_NEAR(moved.position.x, 2.25, 1e-9);

  HandleDrag plane(move, HandlePart::plane_z, ray({0.3, 0.3, 0}), camera);
  change = plane.change(ray({-1, 2, 0}));
  EXPECT_NEAR(change.move.x, -1.3, 1e-9);
  EXPECT_NEAR(change.move.y, 1.7, 1e-9);
  EXPECT_EQ(change.move.z, 0);
  EXPECT_EQ(plane.directions().size(), 2u);
}

TEST_F(HandlesTest, ARayAlongTheAxisKeepsTheLastPlace) {
  HandleDrag drag(handles(HandleMode::move), HandlePart::axis_x, ray({0.5, 0, 0}), camera);
  const HandleChange before = drag.change(ray({1, 0, 0}));
  EXPECT_EQ(drag.change({{-9, 1, 0}, {1, 0, 0}}).move, before.move);
}

TEST_F(HandlesTest, RingsTurnAndCountFullTurns) {
  const Handles rotate = handles(HandleMode::rotate);
  HandleDrag drag(rotate, HandlePart::ring_z, ray({1, 0, 0}), camera);
  EXPECT_NEAR(drag.change(ray({0, 1, 0})).degrees, 90, 1e-6);
  EXPECT_NEAR(drag.change(ray({-1, 0.01, 0})).degrees, 179.427, 1e-2);
  EXPECT_NEAR(drag.change(ray({0, -1, 0})).degrees, 270, 1e-6);
  EXPECT_NEAR(drag.change(ray({1, 0.0001, 0})).degrees, 360, 1e-1);
}

TEST_F(HandlesTest, TurnsKeepRightAnglesExact) {
  const Handles world = handles(HandleMode::rotate, {{1, 2, 3}, {0, 0, 0}, {1, 1, 1}});
  HandleChange change;
  for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0, -1, 0}})
    for (const Vec3 start : {Vec3{0, 0, 0}, Vec3{90, 0, 0}, Vec3{0, 90, 90}, Vec3{0, 0, 180}}) {
      const Placement before{{1, 2, 3}, start, {1, 1, 1}};
      change.axis = axis;
      change.degrees = 90;
      const Placement after = changed(before, {}, world, change);
      Transform wanted = Transform::rotation_degrees(from_glm(axis), 90) *
                         Placement{{0, 0, 0}, start, {1, 1, 1}}.transform();
      wanted.m[3] = 1, wanted.m[7] = 2, wanted.m[11] = 3;
      EXPECT_EQ(after.transform().m, wanted.m);
    }
}

TEST_F(HandlesTest, TurnsInATurnedParent) {
  const Transform parent = Placement{{5, 0, 0}, {90, 0, 0}, {1, 1, 1}}.transform();
  HandleChange change;
  change.axis = {0, 0, 1};
  change.degrees = 30;
  const Handles there = handles(HandleMode::rotate, {{5, 0, 0}, {0, 0, 0}, {1, 1, 1}});
  const Placement after = changed({}, parent, there, change);
  const Vec3 x = (parent * after.transform())({1, 0, 0});
  EXPECT_NEAR(x.x - 5, std::cos(glm::radians(30.0)), 1e-12);
  EXPECT_NEAR(x.y, std::sin(glm::radians(30.0)), 1e-12);
}

TEST_F(HandlesTest, TurnAndScaleAboutTheirOwnPlace) {
  const Placement start{{3, 2, 0}, {0, 0, 0}, {1, 1, 1}};
  Handles there = handles(HandleMode::rotate, {{1, 2, 0}, {0, 0, 0}, {1, 1, 1}});
  HandleChange change;
  change.degrees = 90;
  const Placement turned = changed(start, {}, there, change);
  EXPECT_EQ(turned.position, (Vec3{1, 4, 0}));
  EXPECT_EQ(turned.rotation, (Vec3{0, 0, 90}));
  change = {};
  change.scale = {2, 3, 1};
  const Placement scaled = changed(start, {}, there, change);
  EXPECT_EQ(scaled.position, (Vec3{5, 2, 0}));
  EXPECT_EQ(scaled.scale, (Vec3{2, 3, 1}));
}

TEST_F(HandlesTest, GripsAreFound) {
  for (const HandleMode mode : {HandleMode::move, HandleMode::rotate, HandleMode::scale})
    for (const double azimuth : {-2.5, -1.0, 0.4, 2.0}) {
      camera.azimuth = azimuth;
      const Handles made = handles(mode, {{0.5, 0, 0}, {10, 20, 30}, {1, 1, 1}}, azimuth > 0);
      const int first =
          static_cast<int>(mode == HandleMode::rotate ? HandlePart::ring_x : HandlePart::axis_x);
      const int count = mode == HandleMode::move ? 6 : 3;
      for (int i = first; i < first + count; ++i) {
        const auto part = static_cast<HandlePart>(i);
        // A square seen from its side is a line that ends in the centre.
        if (i >= 3 && i < 6 && std::abs(glm::dot(made.axes[i - 3], camera.forward())) < 0.2)
          continue;
        EXPECT_EQ(made.part_at(camera, seen(made.grip(part, camera)), size), part) << i;
      }
    }
}

TEST_F(HandlesTest, ScalesAlongOneAxisOrAll) {
  const Handles scale = handles(HandleMode::scale);
  HandleDrag drag(scale, HandlePart::axis_y, ray({0, 1, 0}), camera);
  const HandleChange change = drag.change(ray({0, 1.5, 0}));
  EXPECT_NEAR(change.scale.y, 1.5, 1e-9);
  EXPECT_EQ(change.scale.x, 1);
  // Turned by a quarter, the world's y is the node's x.
  const Placement after = changed({{0, 0, 0}, {0, 0, 90}, {1, 1, 1}}, {}, scale, change);
  EXPECT_NEAR(after.scale.x, 1.5, 1e-9);
  EXPECT_EQ(after.scale.y, 1);
  HandleDrag all(scale, HandlePart::centre, ray({0, 0, 0}), camera);
  const glm::dvec3 s = all.change(ray(camera.up() * scale.size)).scale;
  EXPECT_NEAR(s.x, 2, 1e-6);
  EXPECT_EQ(s.x, s.z);
  EXPECT_GT(drag.change(ray({0, -3, 0})).scale.y, 0);
}

TEST_F(HandlesTest, AreDrawnBeforeTheSceneWhereTheyAreSeen) {
  Bounds scene;
  scene.add(glm::dvec3(-2));
  scene.add(glm::dvec3(2));
  for (const bool orthographic : {false, true})
    for (const HandleMode mode : {HandleMode::move, HandleMode::rotate, HandleMode::scale}) {
      camera.orthographic = orthographic;
      const HandlePicture free = draw(handles(mode), {}, camera);
      const HandlePicture before = draw(handles(mode), {}, camera, scene);
      ASSERT_EQ(free.lines.size(), before.lines.size());
      for (std::size_t i = 0; i < free.lines.size(); ++i)
        for (std::size_t k = 0; k < free.lines[i].ends.size(); ++k) {
          const glm::dvec3 p = free.lines[i].ends[k], q = before.lines[i].ends[k];
          EXPECT_NEAR(glm::distance(seen(p), seen(q)), 0, 1e-3);
          const double depth = glm::dot(q - camera.position(), camera.forward());
          for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 c(corner & 1 ? 2 : -2, corner & 2 ? 2 : -2, corner & 4 ? 2 : -2);
            EXPECT_LT(depth, glm::dot(c - camera.position(), camera.forward()));
          }
        }
    }
}

TEST_F(HandlesTest, AreDrawnWhereTheyAreFound) {
  for (const HandleMode mode : {HandleMode::move, HandleMode::rotate, HandleMode::scale}) {
    const Handles made = handles(mode);
    const HandlePicture picture = draw(made, HandlePart::axis_x, camera);
    EXPECT_EQ(picture.surfaces.size(), mode == HandleMode::rotate ? 0u : 3u);
    for (const Lines& lines : picture.lines) {
      EXPECT_TRUE(lines.on_top);
      ASSERT_FALSE(lines.ends.empty());
      EXPECT_EQ(lines.ends.size() % 2, 0u);
      EXPECT_TRUE(made.part_at(camera, seen(glm::dvec3(lines.ends[lines.ends.size() / 2])), size));
    }
  }
}

}  // namespace
}  // namespace sectile::viewer
