// Moving solids: affine maps applied to the input coordinates.
#pragma once

#include <array>

#include "sectile/mesh.h"
#include "sectile/solid.h"

namespace sectile {

/// A 3×4 matrix, row by row: x' = m[0]·x + m[1]·y + m[2]·z + m[3], and so on.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  static Transform translation(const Vec3& by);
  static Transform scaling(const Vec3& by);
  /// Right-handed rotation about an axis through the origin; multiples of a right angle about a
  /// coordinate axis are exact.
  static Transform rotation_degrees(const Vec3& axis, double degrees);
  Vec3 operator()(const Vec3& point) const;
  friend Transform operator*(const Transform& second, const Transform& first);
};

/// Each coordinate rounded to the nearest double; faces that this makes non-planar are split into
/// triangles. Orientation is kept by turning the faces when the map mirrors.
PolygonMesh transformed(const PolygonMesh& mesh, const Transform& transform);
Solid transformed(const Solid& solid, const Transform& transform);

}  // namespace sectile
