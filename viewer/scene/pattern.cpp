#include "scene/pattern.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr std::uint32_t most_copies = 10'000;

/// A linear map about a point that stays.
Transform about(const Vec3& centre, Transform linear) {
  const Vec3 image = linear(centre);
  linear.m[3] = centre.x - image.x;
  linear.m[7] = centre.y - image.y;
  linear.m[11] = centre.z - image.z;
  return linear;
}

void require_direction(const Vec3& axis) {
  if (axis.x == 0 && axis.y == 0 && axis.z == 0)
    throw std::invalid_argument("The axis has no direction: one of its numbers must not be zero.");
}

std::vector<Transform> row(const Pattern& pattern) {
  std::vector<Transform> made;
  for (std::uint32_t i = 0; i < pattern.count; ++i)
    made.push_back(
        Transform::translation({i * pattern.step.x, i * pattern.step.y, i * pattern.step.z}));
  return made;
}

std::vector<Transform> ring(const Pattern& pattern) {
  require_direction(pattern.axis);
  const bool full = std::abs(pattern.degrees) == 360;
  const double parts = std::max(1.0, pattern.count - (full ? 0.0 : 1.0));
  std::vector<Transform> made;
  for (std::uint32_t i = 0; i < pattern.count; ++i)
    made.push_back(about(pattern.centre,
                         Transform::rotation_degrees(pattern.axis, pattern.degrees * i / parts)));
  return made;
}

struct OnPath {
  glm::dvec3 place, direction;
};

/// At a distance from the path's beginning.
OnPath on_path(const std::vector<Vec3>& path, double distance) {
  OnPath found{to_glm(path.front()), {1, 0, 0}};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const glm::dvec3 from = to_glm(path[i]), way = to_glm(path[i + 1]) - from;
    const double length = glm::length(way);
    if (length == 0) continue;
    found.direction = way / length;
    // Within rounding of a corner it is the corner.
    if (distance <= length * (1 + 1e-12)) {
      found.place = from + way * std::min(1.0, distance / length);
      return found;
    }
    distance -= length;
    found.place = to_glm(path[i + 1]);
  }
  return found;
}

std::vector<Transform> along_path(const Pattern& pattern) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < pattern.path.size(); ++i)
    length += glm::distance(to_glm(pattern.path[i]), to_glm(pattern.path[i + 1]));
  if (length == 0) throw std::invalid_argument("The path needs two different points or more.");
  const OnPath start = on_path(pattern.path, 0);
  std::vector<Transform> made;
  for (std::uint32_t i = 0; i < pattern.count; ++i) {
    const OnPath here = on_path(pattern.path, length * i / std::max(1.0, pattern.count - 1.0));
    const glm::dvec3 axis = glm::cross(start.direction, here.direction);
    const double sine = glm::length(axis);
    Transform turn;
    if (pattern.turns && (sine > 1e-12 || glm::dot(start.direction, here.direction) < 0))
      turn = Transform::rotation_degrees(
          sine > 1e-12 ? from_glm(axis / sine) : Vec3{0, 0, 1},
          glm::degrees(std::atan2(sine, glm::dot(start.direction, here.direction))));
    turn = about(from_glm(start.place), turn);
    const glm::dvec3 by = here.place - start.place;
    made.push_back(Transform::translation(from_glm(by)) * turn);
  }
  return made;
}

Transform reflection(const Vec3& centre, const Vec3& normal) {
  require_direction(normal);
  const glm::dvec3 n = to_glm(normal);
  const double square = glm::dot(n, n);
  Transform linear;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      linear.m[static_cast<std::size_t>(4 * row + column)] =
          (row == column ? 1 : 0) - 2 * n[row] * n[column] / square;
  return about(centre, linear);
}

}  // namespace

std::vector<Transform> copies_of(const Pattern& pattern) {
  if (pattern.count < 1 || pattern.count > most_copies)
    throw std::invalid_argument("There must be from 1 to 10000 copies.");
  switch (pattern.kind) {
    case Pattern::Kind::linear:
      return row(pattern);
    case Pattern::Kind::polar:
      return ring(pattern);
    case Pattern::Kind::path:
      return along_path(pattern);
    case Pattern::Kind::mirror: {
      const Transform image = reflection(pattern.centre, pattern.axis);
      return pattern.keeps ? std::vector<Transform>{Transform(), image} : std::vector{image};
    }
  }
  return {};
}

}  // namespace sectile::viewer
