// Vectors in doubles, for bounds: whoever uses them accounts for rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "sectile/mesh.h"

namespace sectile::approximate {

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, const Vec3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) {
  return std::hypot(a.x, a.y, a.z);
}
/// The sum and the greatest of the components' sizes.
inline double sum_norm(const Vec3& a) {
  return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
}
inline double max_norm(const Vec3& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

}  // namespace sectile::approximate
