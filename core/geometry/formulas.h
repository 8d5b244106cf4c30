// What planes and points are, written once for numbers of any kind: Bounded and Dyadic.
#pragma once

#include "geometry/axes.h"
#include "geometry/geometry.h"

namespace sectile {

/// A plane's coefficients: n · x + d is positive on the side to which the normal points.
template <class Number>
struct PlaneOf {
  Number n[3], d;
};

/// A point's homogeneous coordinates; w is not zero.
template <class Number>
struct PointOf {
  Number x[3], w;
};

template <class Number>
Number minor(const Number& a, const Number& b, const Number& c, const Number& d) {
  return a * d - b * c;
}

template <class Number>
Number dot(const Number (&a)[3], const Number (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Has the sign of the plane's side on which the point lies, times that of w.
template <class Number>
Number value_at(const PlaneOf<Number>& s, const PointOf<Number>& p) {
  return dot(s.n, p.x) + s.d * p.w;
}

template <class Number>
Number determinant(const Number (&a)[3], const Number (&b)[3], const Number (&c)[3]) {
  return a[0] * minor(b[1], b[2], c[1], c[2]) + a[1] * minor(b[2], b[0], c[2], c[0]) +
         a[2] * minor(b[0], b[1], c[0], c[1]);
}

/// ((q - p) × (r - p)) · e_axis, for explicit points.
template <class Number>
Number turn_of(const Vec3& p, const Vec3& q, const Vec3& r, int axis) {
  const int i = next_axis(axis), j = next_next_axis(axis);
  const auto along = [&](const Vec3& to, int k) {
    return Number::difference(component(to, k), component(p, k));
  };
  return minor(along(q, i), along(q, j), along(r, i), along(r, j));
}

/// The same times p.w · q.w · r.w: the determinant of the three homogeneous points.
template <class Number>
Number turn_of(const PointOf<Number>& p, const PointOf<Number>& q, const PointOf<Number>& r,
               int axis) {
  const int i = next_axis(axis), j = next_next_axis(axis);
  return p.x[i] * minor(q.x[j], q.w, r.x[j], r.w) - p.x[j] * minor(q.x[i], q.w, r.x[i], r.w) +
         p.w * minor(q.x[i], q.x[j], r.x[i], r.x[j]);
}

template <class Number>
PlaneOf<Number> plane_of(const PlaneCoefficients& k) {
  return {{Number(k.a), Number(k.b), Number(k.c)}, Number(k.d)};
}

/// The axis of a plane that contains an axis direction.
inline int axis_of(PlaneDefinition::Kind kind) {
  return static_cast<int>(kind) - static_cast<int>(PlaneDefinition::Kind::along_x);
}

template <class Number>
PlaneOf<Number> plane_of(const ExactCoefficients& k) {
  return {{k.n[0].as<Number>(), k.n[1].as<Number>(), k.n[2].as<Number>()}, k.d.as<Number>()};
}

template <class Number>
PointOf<Number> point_of(const Vec3& p) {
  return {{Number(p.x), Number(p.y), Number(p.z)}, Number(1.0)};
}

/// Of a point that is explicit or moved.
template <class Number>
PointOf<Number> given_point(const Geometry& g, PointId p) {
  if (!g.is_moved(p)) return point_of<Number>(g.position(p));
  const MovedPoint& how = g.moved_point_of(p);
  PointOf<Number> made;
  g.frames[how.frame]->map(how.local, made.x);
  made.w = Number(1.0);
  return made;
}

/// to - from, for given points.
template <class Number>
void difference(const Geometry& g, PointId from, PointId to, Number (&made)[3]) {
  if (!g.is_moved(from) && !g.is_moved(to)) {
    const Vec3 &p = g.position(from), &q = g.position(to);
    made[0] = Number::difference(q.x, p.x);
    made[1] = Number::difference(q.y, p.y);
    made[2] = Number::difference(q.z, p.z);
    return;
  }
  const PointOf<Number> p = given_point<Number>(g, from), q = given_point<Number>(g, to);
  for (int k = 0; k < 3; ++k) made[k] = q.x[k] - p.x[k];
}

/// u × v
template <class Number>
void cross(const Number (&u)[3], const Number (&v)[3], Number (&made)[3]) {
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    made[k] = minor(u[i], u[j], v[i], v[j]);
  }
}

template <class Number>
PlaneOf<Number> plane_of(const Geometry& g, PlaneId plane) {
  using Kind = PlaneDefinition::Kind;
  const PlaneDefinition& s = g.definition(plane);
  if (s.kind() == Kind::coefficients) return plane_of<Number>(g.coefficients[s.a]);
  if (s.kind() == Kind::exact_coefficients) return plane_of<Number>(*g.exact_coefficients[s.a]);
  Number u[3];
  difference(g, PointId(s.a), PointId(s.b), u);
  PlaneOf<Number> made;
  if (s.kind() == Kind::three_points) {
    Number v[3];
    difference(g, PointId(s.a), PointId(s.c), v);
    cross(u, v, made.n);
  } else if (s.kind() == Kind::along_direction) {
    const ExactDirection& along = *g.directions[s.direction()];
    const Number v[3] = {along.d[0].as<Number>(), along.d[1].as<Number>(), along.d[2].as<Number>()};
    cross(u, v, made.n);
  } else {
    // u × e_axis
    const int axis = axis_of(s.kind()), i = next_axis(axis), j = next_next_axis(axis);
    made.n[i] = u[j];
    made.n[j] = -u[i];
  }
  made.d = -dot(made.n, given_point<Number>(g, PointId(s.a)).x);
  return made;
}

/// line(u, v) ∩ s: u·w - side(u)·(v - u) with w = n·(v - u).
template <class Number>
PointOf<Number> line_plane_point(const Geometry& g, PointId from, PointId to,
                                 const PlaneOf<Number>& s) {
  const PointOf<Number> u = given_point<Number>(g, from);
  Number along[3];
  difference(g, from, to, along);
  const Number w = dot(s.n, along), side = dot(s.n, u.x) + s.d;
  return {
      {u.x[0] * w - side * along[0], u.x[1] * w - side * along[1], u.x[2] * w - side * along[2]},
      w};
}

/// Cramer's rule; bc = b × c and so on.
template <class Number>
PointOf<Number> three_plane_point(const PlaneOf<Number>& a, const PlaneOf<Number>& b,
                                  const PlaneOf<Number>& c) {
  PointOf<Number> made;
  Number bc[3];
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    bc[k] = minor(b.n[i], b.n[j], c.n[i], c.n[j]);
    made.x[k] = -(a.d * bc[k] + b.d * minor(c.n[i], c.n[j], a.n[i], a.n[j]) +
                  c.d * minor(a.n[i], a.n[j], b.n[i], b.n[j]));
  }
  made.w = dot(a.n, bc);
  return made;
}

/// `plane_at(id)` gives the planes' coefficients.
template <class Number, class PlaneAt>
PointOf<Number> constructed_point(const Geometry& g, const Construction& how, PlaneAt&& plane_at) {
  if (how.line_from.valid())
    return line_plane_point<Number>(g, how.line_from, how.line_to, plane_at(how.c));
  return three_plane_point<Number>(plane_at(how.a), plane_at(how.b), plane_at(how.c));
}

}  // namespace sectile
