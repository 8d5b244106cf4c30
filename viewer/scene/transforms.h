// Maps of doubles that handles, files and the evaluator need beyond those of the library.
#pragma once

#include <glm/glm.hpp>

#include "sectile/box_search.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

inline glm::dvec3 to_glm(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Vec3 from_glm(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}
/// From the one to the other, and as far beyond.
inline Extent extent_around(const glm::dvec3& a, const glm::dvec3& b, double margin = 0) {
  return {from_glm(glm::min(a, b) - margin), from_glm(glm::max(a, b) + margin)};
}
glm::dmat4 matrix_of(const Transform& transform);
Transform transform_of(const glm::dmat4& matrix);
bool is_identity(const Transform& transform);
/// Exact for maps that move only. Throws std::invalid_argument for a singular map.
Transform inverse(const Transform& transform);
/// The half-space in the coordinates that `to_world` starts from.
HalfSpace pulled_back(const HalfSpace& in_world, const Transform& to_world);

}  // namespace sectile::viewer
