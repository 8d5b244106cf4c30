#include "picture/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sectile::viewer {
namespace {

Camera some_camera(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Camera camera;
  camera.target = {3 * u(random), 3 * u(random), 3 * u(random)};
  camera.distance = 6 + 4 * u(random);
  camera.azimuth = 3 * u(random);
  camera.elevation = 1.4 * u(random);
  camera.orthographic = u(random) > 0;
  return camera;
}

TEST(Camera, RaysPassThroughWhatIsProjected) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  const glm::dvec2 size(800, 500);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = some_camera(random);
    const glm::dvec3 point = camera.target + glm::dvec3(u(random), u(random), u(random));
    const glm::dvec3 on_screen = camera.project(point, size);
    const Ray ray = camera.ray(glm::dvec2(on_screen), size);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
    const glm::dvec3 to_point = point - ray.origin;
    EXPECT_NEAR(glm::length(glm::cross(to_point, ray.direction)), 0, 1e-9);
    EXPECT_GT(glm::dot(to_point, ray.direction), 0);
  }
}

TEST(Camera, MatricesAgreeWithProject) {
  std::mt19937 random(2);
  const glm::dvec2 size(640, 400);
  for (int i = 0; i < 50; ++i) {
    const Camera camera = some_camera(random);
    const glm::dvec3 point = camera.target + glm::dvec3(0.3, -0.2, 0.5);
    Bounds bounds;
    bounds.add(camera.target - 2.0);
    bounds.add(camera.target + 2.0);
    const glm::dvec4 clip = camera.projection(1.6, bounds) * camera.view() * glm::dvec4(point, 1);
    const glm::dvec3 expected = camera.project(point, size);
    EXPECT_NEAR((clip.x / clip.w + 1) / 2 * size.x, expected.x, 1e-8);
    EXPECT_NEAR((1 - clip.y / clip.w) / 2 * size.y, expected.y, 1e-8);
    EXPECT_LT(std::abs(clip.z / clip.w), 1);
  }
}

TEST(Camera, OrbitKeepsTargetInTheMiddleAndNeverTurnsOver) {
  Camera camera;
  camera.target = {1, 2, 3};
  const glm::dvec2 size(800, 600);
  for (int i = 0; i < 100; ++i) {
    camera.orbit(0.37, 0.11);
    const glm::dvec3 middle = camera.project({1, 2, 3}, size);
    EXPECT_NEAR(middle.x, 400, 1e-9);
    EXPECT_NEAR(middle.y, 300, 1e-9);
    EXPECT_NEAR(middle.z, camera.distance, 1e-9);
    EXPECT_GT(camera.up().z, 0);
  }
}

TEST(Camera, PanAndZoomKeepWhatIsUnderTheMouse) {
  std::mt19937 random(3);
  const glm::dvec2 size(800, 600), pixel(123, 456);
  for (int i = 0; i < 50; ++i) {
    Camera camera = some_camera(random);
    const glm::dvec3 target = camera.target;
    camera.pan({50, -20}, size);
    EXPECT_NEAR(camera.project(target, size).x, 450, 1e-8);
    EXPECT_NEAR(camera.project(target, size).y, 280, 1e-8);

    const Ray ray = camera.ray(pixel, size);
    const double along = glm::dot(camera.target - ray.origin, camera.forward()) /
                         glm::dot(ray.direction, camera.forward());
    const glm::dvec3 under = ray.origin + ray.direction * along;
    camera.zoom(0.7, pixel, size);
    EXPECT_NEAR(camera.project(under, size).x, pixel.x, 1e-8);
    EXPECT_NEAR(camera.project(under, size).y, pixel.y, 1e-8);
  }
}

TEST(Camera, LookAtShowsAllCorners) {
  std::mt19937 random(4);
  Bounds bounds;
  bounds.add(glm::dvec3(-1, -5, 0));
  bounds.add(glm::dvec3(4, 2, 1));
  for (int i = 0; i < 50; ++i) {
    Camera camera = some_camera(random);
    camera.look_at(bounds, 1.6);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? 4 : -1, corner & 2 ? 2 : -5, corner & 4 ? 1 : 0);
      const glm::dvec3 seen = camera.project(p, {1600, 1000});
      EXPECT_TRUE(seen.x > 0 && seen.x < 1600 && seen.y > 0 && seen.y < 1000);
    }
  }
}

}  // namespace
}  // namespace sectile::viewer
