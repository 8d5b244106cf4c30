// Axes 0, 1, 2 and the coordinates on them.
#pragma once

#include "sectile/mesh.h"

namespace sectile {

constexpr int next_axis(int axis) {
  return axis == 2 ? 0 : axis + 1;
}
constexpr int next_next_axis(int axis) {
  return axis == 0 ? 2 : axis - 1;
}
constexpr double component(const Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

constexpr double& component(Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace sectile
