// Point in mesh by counting crossings of a ray, for meshes with small integer coordinates and
// points at half-integer or third places: independent of the library, and exact.
#pragma once

#include "sectile/mesh.h"

namespace sectile::test {

/// The ray leaves the point in direction +x; its y and z must not be those of an edge of the mesh
/// seen along x, which the caller ensures by the choice of the point.
inline bool is_inside(const PolygonMesh& mesh, const Vec3& p) {
  bool inside = false;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    const auto turn = [&](const Vec3& u, const Vec3& v) {
      return (v.y - u.y) * (p.z - u.z) - (v.z - u.z) * (p.y - u.y);
    };
    const double s = turn(a, b), t = turn(b, c), r = turn(c, a);
    if (!((s > 0 && t > 0 && r > 0) || (s < 0 && t < 0 && r < 0))) continue;
    // The triangle's x at (y, z), weighted by the areas.
    const double x = (a.x * t + b.x * r + c.x * s) / (s + t + r);
    if (x > p.x) inside = !inside;
  }
  return inside;
}

}  // namespace sectile::test
