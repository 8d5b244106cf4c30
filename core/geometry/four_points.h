// A fourth point against the plane of three, where they are near each other: the differences of
// their coordinates are small and often exact, so that doubles decide far more than they do with
// the plane's equation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/geometry.h"
#include "numbers/sign.h"

namespace sectile {

/// The axis against which most of a face with this normal is seen.
inline int main_axis(const std::array<double, 3>& normal) {
  const double n[3] = {std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])};
  return n[0] >= n[1] ? (n[0] >= n[2] ? 0 : 2) : (n[1] >= n[2] ? 1 : 2);
}

/// The plane of three points, for several questions: its normal in doubles, and what the products
/// of each coordinate of it sum up to.
class NormalOfThree {
 public:
  NormalOfThree() = default;
  NormalOfThree(const Vec3& a, const Vec3& b, const Vec3& c) : corner(a) {
    const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = k < 2 ? k + 1 : 0, j = i < 2 ? i + 1 : 0;
      const double left = u[i] * v[j], right = u[j] * v[i];
      normal[k] = left - right;
      size[k] = std::abs(left) + std::abs(right);
    }
  }

  /// Seen against an axis, do the points certainly turn left, or right? Zero if doubles do not
  /// tell.
  Sign clear_turn(int axis) const {
    const auto k = static_cast<std::size_t>(axis);
    // Three roundings of half an ulp in each product, and one of the difference.
    const bool is_clear =
        size[k] > 0x1p-700 && size[k] < 0x1p700 && std::abs(normal[k]) > 8 * 0x1p-53 * size[k];
    return is_clear ? sign_of(normal[k]) : Sign::zero;
  }

  /// Are the points certainly not in one line?
  bool clearly_bent() const {
    for (int axis = 0; axis < 3; ++axis)
      if (clear_turn(axis) != Sign::zero) return true;
    return false;
  }

  /// On which side of the plane d certainly is: positive where the points turn left as seen from d.
  /// Zero if doubles do not tell.
  Sign clear_side(const Vec3& d) const {
    const double w[3] = {d.x - corner.x, d.y - corner.y, d.z - corner.z};
    const double reach = std::max({std::abs(w[0]), std::abs(w[1]), std::abs(w[2])});
    const double value = w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2];
    const double sum =
        std::abs(w[0]) * size[0] + std::abs(w[1]) * size[1] + std::abs(w[2]) * size[2];
    // Three roundings of differences, two of products, one of the normal and two of sums, of 2^-53
    // each: less than nine. Underflow of products is nothing beside a sum of that order.
    if (reach < 0x1p200 && sum > 0x1p-700 && std::abs(value) > 9 * 0x1p-53 * sum)
      return sign_of(value);
    return Sign::zero;
  }

  /// Is d certainly not in the plane?
  bool clearly_off(const Vec3& d) const { return clear_side(d) != Sign::zero; }

  Vec3 corner;  ///< one of the points
  std::array<double, 3> normal = {}, size = {};
};

inline Sign clear_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return NormalOfThree(a, b, c).clear_side(d);
}
/// The same, decided exactly: zero if the points are in one plane.
Sign side_of_three(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Is d certainly not in the plane of the others?
inline bool clearly_off_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return NormalOfThree(a, b, c).clearly_off(d);
}

/// Are four points in one plane? Decided exactly.
bool in_one_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Six times the volume of the tetrahedron that four points span, without sign; rounded once.
double six_times_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Is a point certainly not in a plane of a geometry? False if that takes more than looking at
/// given points.
inline bool clearly_off_plane(const Geometry& geometry, PointId point, PlaneId plane) {
  const PlaneDefinition& how = geometry.definition(plane);
  if (how.kind() != PlaneDefinition::Kind::three_points) return false;
  const PointId a(how.a), b(how.b), c(how.c);
  for (const PointId p : {a, b, c, point})
    if (!geometry.is_explicit(p)) return false;
  return clearly_off_plane(geometry.position(a), geometry.position(b), geometry.position(c),
                           geometry.position(point));
}

/// Are three points certainly not in one line?
inline bool clearly_bent(const Vec3& a, const Vec3& b, const Vec3& c) {
  return NormalOfThree(a, b, c).clearly_bent();
}

}  // namespace sectile
