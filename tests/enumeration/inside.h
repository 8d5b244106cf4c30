// Point in mesh by counting the triangles that a ray passes through, independently of the library.
// Exact when the coordinates are small multiples of a power of two, as those of lattice solids are.
#pragma once

#include <tuple>

#include "sectile/mesh.h"

namespace sectile::test {

/// The ray leaves the point in direction +x. It is taken to run beside the point by ε in y and by
/// ε² in z, so that it meets no edge. The mesh consists of triangles.
inline bool is_inside(const PolygonMesh& mesh, const Vec3& p) {
  // Which side of the line from u to v, seen along x, the ray is on.
  const auto ascending = [&](const Vec3& u, const Vec3& v) {
    const double y = v.y - u.y, z = v.z - u.z;
    const double turn = y * (p.z - u.z) - z * (p.y - u.y);
    return turn != 0 ? turn : z != 0 ? -z : y;
  };
  // Rounding must not decide differently for the two triangles at an edge.
  const auto side = [&](const Vec3& u, const Vec3& v) {
    return std::tie(u.x, u.y, u.z) < std::tie(v.x, v.y, v.z) ? ascending(u, v) : -ascending(v, u);
  };
  bool inside = false;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    const bool left = side(a, b) > 0;
    if (left != (side(b, c) > 0) || left != (side(c, a) > 0)) continue;
    // The plane's distance along x times the normal's x.
    const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const double nx = u.y * v.z - u.z * v.y;
    const double ahead = nx * (a.x - p.x) + (u.z * v.x - u.x * v.z) * (a.y - p.y) +
                         (u.x * v.y - u.y * v.x) * (a.z - p.z);
    if ((ahead > 0) == (nx > 0) && ahead != 0) inside = !inside;
  }
  return inside;
}

}  // namespace sectile::test
