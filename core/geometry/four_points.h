// A fourth point against the plane of three, where they are near each other: the differences of
// their coordinates are small and often exact, so that doubles decide far more than they do with
// the plane's equation.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/geometry.h"

namespace sectile {

/// Is d certainly not in the plane of the others?
inline bool clearly_off_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double u[3] = {a.x - d.x, a.y - d.y, a.z - d.z}, v[3] = {b.x - d.x, b.y - d.y, b.z - d.z},
               w[3] = {c.x - d.x, c.y - d.y, c.z - d.z};
  double value = 0, size = 0, reach = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double left = v[i] * w[j], right = v[j] * w[i];
    value += u[k] * (left - right);
    size += std::abs(u[k]) * (std::abs(left) + std::abs(right));
    reach = std::max({reach, std::abs(u[k]), std::abs(v[k]), std::abs(w[k])});
  }
  // Seven roundings of half an ulp in each term, and two of sums: less than 16 units of 2^-53, with
  // room. Underflow of products is nothing beside a size of that order.
  return reach < 0x1p200 && size > 0x1p-700 && std::abs(value) > 16 * 0x1p-53 * size;
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
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double left = u[i] * v[j], right = u[j] * v[i], size = std::abs(left) + std::abs(right);
    // Three roundings of half an ulp in each product, and one of the difference.
    if (size > 0x1p-700 && size < 0x1p700 && std::abs(left - right) > 8 * 0x1p-53 * size)
      return true;
  }
  return false;
}

}  // namespace sectile
