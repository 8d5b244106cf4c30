#include "app/sphere_inside.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sectile::viewer {
namespace {

constexpr float same_point = 1e-4f;

/// Angle from the arc's beginning to a direction of its plane, counter-clockwise about the normal.
float angle_along(const SpherePicture::Arc& arc, const glm::vec3& direction) {
  const glm::vec3 across = glm::cross(arc.normal, arc.from);
  float angle = std::atan2(glm::dot(direction, across), glm::dot(direction, arc.from));
  return angle < 0 ? angle + 2 * std::numbers::pi_v<float> : angle;
}

float length_of(const SpherePicture::Arc& arc) {
  if (glm::distance(arc.from, arc.to) < same_point) return 2 * std::numbers::pi_v<float>;
  return angle_along(arc, arc.to);
}

}  // namespace

std::vector<glm::vec3> points_of(const SpherePicture::Arc& arc) {
  const float length = length_of(arc);
  const int pieces = std::max(2, static_cast<int>(length * 24));
  const glm::vec3 across = glm::cross(arc.normal, arc.from);
  std::vector<glm::vec3> points;
  for (int i = 0; i <= pieces; ++i) {
    const float angle = length * static_cast<float>(i) / static_cast<float>(pieces);
    points.push_back(std::cos(angle) * arc.from + std::sin(angle) * across);
  }
  return points;
}

bool is_inside(const SpherePicture& picture, int solid, const glm::vec3& d) {
  // The nearest point of all arcs; where two arcs share it, the one whose plane is farther from `d`
  // decides, as at the edges of a convex or a concave corner.
  float best = -2, best_height = 0;
  for (const SpherePicture::Arc& arc : picture.arcs) {
    if (arc.solid != solid) continue;
    const float height = glm::dot(d, arc.normal);
    const glm::vec3 in_plane = d - height * arc.normal;
    const float length = glm::length(in_plane);
    float nearness = std::max(glm::dot(d, arc.from), glm::dot(d, arc.to));
    if (length > same_point && angle_along(arc, in_plane) <= length_of(arc))
      nearness = std::max(nearness, length);
    const bool tie = std::abs(nearness - best) < same_point;
    if ((tie && std::abs(height) > std::abs(best_height)) || (!tie && nearness > best)) {
      best = std::max(best, nearness);
      best_height = height;
    }
  }
  return best > -2 && best_height < 0;
}

}  // namespace sectile::viewer
