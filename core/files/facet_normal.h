// The normals that STL files carry; nothing here reads them.
#pragma once

#include <algorithm>
#include <cmath>

#include "sectile/mesh.h"

namespace sectile {

/// The unit normal of a triangle; zero if it has no area. Halved coordinates cannot overflow, and
/// scaled differences neither overflow nor vanish when they are multiplied.
inline Vec3 facet_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 u{b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
  Vec3 v{c.x / 2 - a.x / 2, c.y / 2 - a.y / 2, c.z / 2 - a.z / 2};
  for (Vec3* side : {&u, &v}) {
    const double most = std::max({std::abs(side->x), std::abs(side->y), std::abs(side->z)});
    if (most == 0) return {};
    *side = {side->x / most, side->y / most, side->z / most};
  }
  const Vec3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{};
}

}  // namespace sectile
