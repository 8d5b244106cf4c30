// Moving solids: affine maps, exact for solids and rounded for meshes.
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
  /// coordinate axis are exact. Throws std::invalid_argument if the axis is zero.
  static Transform rotation_degrees(const Vec3& axis, double degrees);
  /// Each coordinate is rounded once, to the nearest double.
  Vec3 operator()(const Vec3& point) const;
  /// First `first`, then `second`; each entry is rounded once.
  friend Transform operator*(const Transform& second, const Transform& first);
};

/// Each coordinate rounded to the nearest double. Orientation is kept by turning the faces when the
/// map mirrors. Throws std::invalid_argument for a matrix that is singular or not finite, and if an
/// image is too large for doubles.
PolygonMesh transformed(const PolygonMesh& mesh, const Transform& transform);

/// The exact image of a solid: nothing is rounded, no face is added, and it always succeeds. Moves
/// one after the other are multiplied exactly, so that a move back is the solid; solids that were
/// flush stay so if they are moved alike. Takes next to no time: points are computed when they are
/// first asked for. The faces keep their FaceSource and the solid its origin(). Its numbers grow
/// with each move that doubles cannot follow; Booleans of moved solids take a little longer than
/// those of solids with coordinates in doubles, which the mesh's transform gives.
Solid transformed(const Solid& solid, const Transform& transform);

}  // namespace sectile
