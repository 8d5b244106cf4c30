#include "lattice_solid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "storage/solid_data.h"

namespace sectile::test {
namespace {

struct Vector {
  std::int64_t x, y, z;
};
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// A point that defines a plane.
Vector integers(const Geometry& geometry, std::uint32_t point) {
  const PointId id(point);
  const Vec3& p = geometry.position(id);
  const Vector v{static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y),
                 static_cast<std::int64_t>(p.z)};
  if (!geometry.is_explicit(id) || Vec3{double(v.x), double(v.y), double(v.z)} != p)
    throw std::logic_error("a point that should be an integer point is not");
  return v;
}

LatticePlane plane_of(const Geometry& geometry, PlaneId id) {
  const PlaneDefinition& definition = geometry.definition(id);
  const Vector a = integers(geometry, definition.a), b = integers(geometry, definition.b);
  const Vector u{b.x - a.x, b.y - a.y, b.z - a.z};
  Vector v{};
  switch (definition.kind()) {
    case PlaneDefinition::Kind::three_points: {
      const Vector c = integers(geometry, definition.c);
      v = {c.x - a.x, c.y - a.y, c.z - a.z};
      break;
    }
    case PlaneDefinition::Kind::along_x:
      v = {1, 0, 0};
      break;
    case PlaneDefinition::Kind::along_y:
      v = {0, 1, 0};
      break;
    case PlaneDefinition::Kind::along_z:
      v = {0, 0, 1};
      break;
    case PlaneDefinition::Kind::coefficients:
    case PlaneDefinition::Kind::exact_coefficients:
    case PlaneDefinition::Kind::along_direction:
      throw std::logic_error("a plane that is not through points");
  }
  const Vector n = cross(u, v);
  return {n.x, n.y, n.z, n.x * a.x + n.y * a.y + n.z * a.z};
}

// Cramer's rule.
LatticePoint meet(const LatticePlane& p, const LatticePlane& q, const LatticePlane& r) {
  const Vector qr = cross({q.a, q.b, q.c}, {r.a, r.b, r.c}),
               rp = cross({r.a, r.b, r.c}, {p.a, p.b, p.c}),
               pq = cross({p.a, p.b, p.c}, {q.a, q.b, q.c});
  return LatticePoint::reduced(
      p.d * qr.x + q.d * rp.x + r.d * pq.x, p.d * qr.y + q.d * rp.y + r.d * pq.y,
      p.d * qr.z + q.d * rp.z + r.d * pq.z, p.a * qr.x + p.b * qr.y + p.c * qr.z);
}

// Points whose coordinates are doubles are kept as such.
LatticePoint exact(Vec3 p) {
  std::int64_t w = 1;
  for (; p.x != std::floor(p.x) || p.y != std::floor(p.y) || p.z != std::floor(p.z); w *= 2)
    p = {2 * p.x, 2 * p.y, 2 * p.z};
  return LatticePoint::reduced(static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y),
                               static_cast<std::int64_t>(p.z), w);
}

LatticePoint exact(const Geometry& geometry, PointId id) {
  if (geometry.is_explicit(id)) return exact(geometry.position(id));
  const Construction& how = geometry.construction(id);
  return meet(plane_of(geometry, how.a), plane_of(geometry, how.b), plane_of(geometry, how.c));
}

}  // namespace

std::vector<LatticePoint> exact_corners(const Solid& solid) {
  std::vector<LatticePoint> points;
  if (solid.is_empty()) return points;
  for (const PointId p : solid.data()->brep().point)
    points.push_back(exact(solid.data()->geometry(), p));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Rational exact_volume(const Solid& solid) {
  Rational sum = 0;
  if (solid.is_empty()) return sum;
  const Brep& brep = solid.data()->brep();
  std::vector<LatticePoint> corners;
  for (std::size_t l = 0; l < brep.loop_count(); ++l) {
    corners.clear();
    for_each_in_loop(brep, LoopId(l), [&](HalfEdgeId h) {
      corners.push_back(exact(solid.data()->geometry(), brep.point_of(brep.from(h))));
    });
    sum += six_volumes(corners);
  }
  return sum / 6;
}

}  // namespace sectile::test
