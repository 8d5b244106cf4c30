// Placements as maps, and the placement that a map stands for.
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "scene/scene.h"

namespace sectile::viewer {

namespace {

// Angles that were computed come within rounding of those that were meant.
double cleaned_degrees(double radians) {
  const double degrees = glm::degrees(radians);
  const double round = std::round(degrees * 1024) / 1024;
  const double tidy = std::abs(degrees - round) < 1e-11 ? round : degrees;
  return tidy == 0 ? 0 : tidy;
}

double cleaned_scale(double scale) {
  const double round = std::round(scale * 1024) / 1024;
  return round != 0 && std::abs(scale - round) < 1e-14 * std::abs(round) ? round : scale;
}

bool is_diagonal(const std::array<double, 12>& m) {
  return m[1] == 0 && m[2] == 0 && m[4] == 0 && m[6] == 0 && m[8] == 0 && m[9] == 0;
}

// R = Rz·Ry·Rx has the rows (cy·cz, …), (cy·sz, …), (-sy, cy·sx, cy·cx).
Vec3 angles(const glm::dmat3& r) {
  const double sine = glm::clamp(-r[0][2], -1.0, 1.0);
  const double y = std::atan2(sine, std::hypot(r[0][0], r[0][1]));
  if (std::hypot(r[1][2], r[2][2]) > 1e-12)
    return {cleaned_degrees(std::atan2(r[1][2], r[2][2])), cleaned_degrees(y),
            cleaned_degrees(std::atan2(r[0][1], r[0][0]))};
  // Turned onto the z axis, x and z do the same: all of it is given to z.
  return {0, cleaned_degrees(y), cleaned_degrees(std::atan2(-r[1][0], r[1][1]))};
}

/// a + b as the nearest double, and what that lacks.
std::pair<double, double> exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// high + low + by, as two doubles that do not overlap.
void add(double& high, double& low, double by) {
  const auto [first, lost] = exact_sum(high, by);
  const auto [middle, least] = exact_sum(lost, low);
  const auto [sum, rest] = exact_sum(first, middle);
  const auto [made, left] = exact_sum(sum, rest + least);
  high = made;
  low = std::isfinite(made) ? left : 0;
}

}  // namespace

void Placement::move(const Vec3& by) {
  if (by.x != 0) add(position.x, remainder.x, by.x);
  if (by.y != 0) add(position.y, remainder.y, by.y);
  if (by.z != 0) add(position.z, remainder.z, by.z);
}

ExactTransform Placement::exact() const {
  Transform made = transform();
  made.m[3] = position.x;
  made.m[7] = position.y;
  made.m[11] = position.z;
  if (remainder == Vec3{0, 0, 0}) return made;
  return ExactTransform(Transform::translation(remainder)) * made;
}

Transform Placement::transform() const {
  Transform made = Transform::scaling(scale);
  if (rotation.x != 0) made = Transform::rotation_degrees({1, 0, 0}, rotation.x) * made;
  if (rotation.y != 0) made = Transform::rotation_degrees({0, 1, 0}, rotation.y) * made;
  if (rotation.z != 0) made = Transform::rotation_degrees({0, 0, 1}, rotation.z) * made;
  made.m[3] = position.x + remainder.x;
  made.m[7] = position.y + remainder.y;
  made.m[11] = position.z + remainder.z;
  return made;
}

Placement Placement::of(const ExactTransform& transform) {
  Placement made = of(transform.nearest());
  const ExactTransform none;
  const WeightedImage lacking[] = {{transform, {0, 0, 0}, 1}, {none, made.position, -1}};
  made.remainder = sum_of_images(lacking);
  return made;
}

Placement Placement::of(const Transform& transform) {
  const auto& m = transform.m;
  Placement made;
  made.position = {m[3], m[7], m[11]};
  if (is_diagonal(m)) {
    made.scale = {m[0], m[5], m[10]};
    return made;
  }
  glm::dmat3 columns{{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}};
  glm::dvec3 scale{glm::length(columns[0]), glm::length(columns[1]), glm::length(columns[2])};
  if (glm::determinant(columns) < 0) scale.z = -scale.z;
  for (int i = 0; i < 3; ++i)
    if (scale[i] != 0) columns[i] /= scale[i];
  // What shear there is goes: the x axis stays, the y axis keeps its plane.
  const glm::dvec3 x = columns[0];
  const glm::dvec3 y = glm::normalize(columns[1] - x * glm::dot(x, columns[1]));
  made.rotation = angles({x, y, glm::cross(x, y)});
  made.scale = {cleaned_scale(scale.x), cleaned_scale(scale.y), cleaned_scale(scale.z)};
  return made;
}

}  // namespace sectile::viewer
