// Points and planes that are the same for a reason that needs no arithmetic.
#pragma once

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

}  // namespace sectile
