#include "picture/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace sectile::viewer {
namespace {

constexpr double steepest = 0.4999 * std::numbers::pi;

// Where a pixel lies in the picture plane: -1 … 1 from left to right and from bottom to top.
glm::dvec2 normalised(glm::dvec2 pixel, glm::dvec2 size) {
  return {2 * pixel.x / size.x - 1, 1 - 2 * pixel.y / size.y};
}

// Half the height of what is seen at distance one, or anywhere if orthographic.
double half_height(const Camera& camera) {
  const double at_one = std::tan(camera.field_of_view / 2);
  return camera.orthographic ? at_one * camera.distance : at_one;
}

}  // namespace

glm::dvec3 Camera::forward() const {
  return -glm::dvec3(std::cos(elevation) * std::cos(azimuth),
                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
}

glm::dvec3 Camera::right() const {
  return {-std::sin(azimuth), std::cos(azimuth), 0};
}

glm::dvec3 Camera::up() const {
  return glm::cross(right(), forward());
}

glm::dvec3 Camera::position() const {
  return target - forward() * distance;
}

glm::dmat4 Camera::view() const {
  const glm::dvec3 x = right(), y = up(), z = -forward(), p = position();
  return glm::dmat4(glm::dvec4(x.x, y.x, z.x, 0), glm::dvec4(x.y, y.y, z.y, 0),
                    glm::dvec4(x.z, y.z, z.z, 0),
                    glm::dvec4(-glm::dot(x, p), -glm::dot(y, p), -glm::dot(z, p), 1));
}

glm::dmat4 Camera::projection(double aspect, const Bounds& scene) const {
  double near_depth = distance * 0.5, far_depth = distance * 2;
  if (!scene.is_empty()) {
    const glm::dvec3 f = forward();
    const double centre = glm::dot(scene.centre() - position(), f);
    const double reach = glm::dot((scene.high - scene.low) * 0.5, glm::abs(f));
    const double margin = 0.01 * (reach + distance);
    near_depth = centre - reach - margin;
    far_depth = centre + reach + margin;
  }
  const double h = half_height(*this);
  if (orthographic) return glm::ortho(-h * aspect, h * aspect, -h, h, near_depth, far_depth);
  // Depth is stored with some 24 bits: too close a near plane would eat them all.
  near_depth = std::max(near_depth, std::max(far_depth * 2e-4, distance * 0.02));
  far_depth = std::max(far_depth, near_depth * 1.01);
  return glm::perspective(field_of_view, aspect, near_depth, far_depth);
}

Ray Camera::ray(glm::dvec2 pixel, glm::dvec2 size) const {
  const glm::dvec2 n = normalised(pixel, size) * half_height(*this);
  const glm::dvec3 aside = right() * (n.x * size.x / size.y) + up() * n.y;
  if (orthographic) return {position() + aside, forward()};
  return {position(), glm::normalize(forward() + aside)};
}

glm::dvec3 Camera::project(const glm::dvec3& point, glm::dvec2 size) const {
  const glm::dvec3 v = point - position();
  const double depth = glm::dot(v, forward());
  const double h = half_height(*this) * (orthographic ? 1.0 : depth);
  const double x = glm::dot(v, right()) / (h * size.x / size.y), y = glm::dot(v, up()) / h;
  return {(x + 1) * 0.5 * size.x, (1 - y) * 0.5 * size.y, depth};
}

double Camera::pixel_length(const glm::dvec3& point, glm::dvec2 size) const {
  const double depth = std::abs(glm::dot(point - position(), forward()));
  return 2 * half_height(*this) * (orthographic ? 1.0 : depth) / size.y;
}

void Camera::orbit(double radians_right, double radians_up) {
  azimuth = std::remainder(azimuth - radians_right, 2 * std::numbers::pi);
  elevation = std::clamp(elevation + radians_up, -steepest, steepest);
}

void Camera::pan(glm::dvec2 pixels, glm::dvec2 size) {
  target += (up() * pixels.y - right() * pixels.x) * pixel_length(target, size);
}

void Camera::zoom(double factor, glm::dvec2 pixel, glm::dvec2 size) {
  // The point of the target's plane under the pixel is the fixed point of the scaling.
  const Ray through = ray(pixel, size);
  const double along = glm::dot(target - through.origin, forward());
  const glm::dvec3 fixed =
      through.origin + through.direction * (along / glm::dot(through.direction, forward()));
  target = fixed + (target - fixed) * factor;
  distance *= factor;
}

void Camera::look_at(const Bounds& bounds, double aspect) {
  if (bounds.is_empty()) return;
  target = bounds.centre();
  const glm::dvec3 half = (bounds.high - bounds.low) * 0.5;
  const double h = std::tan(field_of_view / 2);
  const double room = 1.12;
  double needed = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 v =
        half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double across =
        std::max(std::abs(glm::dot(v, up())), std::abs(glm::dot(v, right())) / aspect);
    const double closer = orthographic ? 0 : -glm::dot(v, forward());
    needed = std::max(needed, room * across / h + closer);
  }
  distance = std::max(needed, 1e-6 + bounds.radius() * 0.1);
}

}  // namespace sectile::viewer
