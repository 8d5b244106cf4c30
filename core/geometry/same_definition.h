// Points and planes that are the same for a reason that needs no arithmetic.
#pragma once

#include <tuple>

#include "geometry/geometry.h"

namespace sectile {

/// Of two given points.
inline bool clearly_same(const Geometry& geometry, PointId p, PointId q) {
  if (p == q) return true;
  if (geometry.is_explicit(p))
    return geometry.is_explicit(q) && geometry.position(p) == geometry.position(q);
  return geometry.is_moved(q) && geometry.moved_point_of(p) == geometry.moved_point_of(q);
}

/// Are two planes defined by the same points?
inline bool have_same_points(const Geometry& geometry, const PlaneDefinition& p,
                             const PlaneDefinition& q) {
  if (p.kind() != q.kind() || !p.has_points()) return false;
  const auto same = [&](std::uint32_t i, std::uint32_t j) {
    return clearly_same(geometry, PointId(i), PointId(j));
  };
  if (!same(p.a, q.a) || !same(p.b, q.b)) return false;
  return p.kind() == PlaneDefinition::Kind::three_points ? same(p.c, q.c) : p.c == q.c;
}

/// An order of definitions in which those with the same points follow each other.
inline bool is_defined_before(const Geometry& geometry, const PlaneDefinition& p,
                              const PlaneDefinition& q) {
  if (p.kind() != q.kind() || !p.has_points())
    return std::tuple(p.kind(), p.a) < std::tuple(q.kind(), q.a);
  const auto content = [&](std::uint32_t i) {
    const PointId point(i);
    const auto [x, y, z] = geometry.position(point);
    if (!geometry.is_moved(point)) return std::tuple(x, y, z, 0u, 0.0, 0.0, 0.0);
    const MovedPoint& how = geometry.moved_point_of(point);
    return std::tuple(x, y, z, how.frame + 1, how.local.x, how.local.y, how.local.z);
  };
  if (p.a != q.a)
    if (const auto u = content(p.a), v = content(q.a); u != v) return u < v;
  if (p.b != q.b)
    if (const auto u = content(p.b), v = content(q.b); u != v) return u < v;
  if (p.kind() != PlaneDefinition::Kind::three_points) return p.c < q.c;
  return p.c != q.c && content(p.c) < content(q.c);
}

}  // namespace sectile
