#include "scene/transforms.h"

#include <cmath>
#include <stdexcept>

namespace sectile::viewer {

glm::dmat4 matrix_of(const Transform& transform) {
  glm::dmat4 made{1};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      made[column][row] = transform.m[static_cast<std::size_t>(4 * row + column)];
  return made;
}

Transform transform_of(const glm::dmat4& matrix) {
  Transform made;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      made.m[static_cast<std::size_t>(4 * row + column)] = matrix[column][row];
  return made;
}

bool is_identity(const Transform& transform) {
  return transform.m == Transform().m;
}

Transform inverse(const Transform& transform) {
  Transform linear = transform;
  linear.m[3] = linear.m[7] = linear.m[11] = 0;
  const Vec3 moved{-transform.m[3], -transform.m[7], -transform.m[11]};
  if (is_identity(linear)) return Transform::translation(moved);
  const glm::dmat4 matrix = matrix_of(linear);
  const double determinant = glm::determinant(glm::dmat3(matrix));
  if (determinant == 0 || !std::isfinite(determinant))
    throw std::invalid_argument("A placement that flattens to nothing cannot be undone.");
  return transform_of(glm::inverse(matrix)) * Transform::translation(moved);
}

// n·(M·p + t) + d = (Mᵀ·n)·p + n·t + d
HalfSpace pulled_back(const HalfSpace& in_world, const Transform& to_world) {
  const auto& m = to_world.m;
  const auto along = [&](std::size_t column) {
    return in_world.a * m[column] + in_world.b * m[4 + column] + in_world.c * m[8 + column];
  };
  return {along(0), along(1), along(2), along(3) + in_world.d};
}

}  // namespace sectile::viewer
