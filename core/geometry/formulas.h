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

/// ((q - p) × (r - p)) · e_axis
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
PlaneOf<Number> plane_of(const Geometry& g, PlaneId plane) {
  using Kind = PlaneDefinition::Kind;
  const PlaneDefinition& s = g.definition(plane);
  if (s.kind() == Kind::coefficients) return plane_of<Number>(g.coefficients[s.a]);
  const Vec3 &a = g.positions[s.a], &b = g.positions[s.b];
  const auto difference = Number::difference;
  const Number u[3] = {difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)};
  PlaneOf<Number> made;
  if (s.kind() == Kind::three_points) {
    const Vec3& c = g.positions[s.c];
    const Number v[3] = {difference(c.x, a.x), difference(c.y, a.y), difference(c.z, a.z)};
    for (int k = 0; k < 3; ++k) {
      const int i = next_axis(k), j = next_next_axis(k);
      made.n[k] = minor(u[i], u[j], v[i], v[j]);
    }
  } else {
    // u × e_axis
    const int axis = axis_of(s.kind()), i = next_axis(axis), j = next_next_axis(axis);
    made.n[i] = u[j];
    made.n[j] = -u[i];
  }
  const Number at[3] = {Number(a.x), Number(a.y), Number(a.z)};
  made.d = -dot(made.n, at);
  return made;
}

template <class Number>
PointOf<Number> point_of(const Vec3& p) {
  return {{Number(p.x), Number(p.y), Number(p.z)}, Number(1.0)};
}

/// line(u, v) ∩ s: u·w - side(u)·(v - u) with w = n·(v - u).
template <class Number>
PointOf<Number> line_plane_point(const Vec3& from, const Vec3& to, const PlaneOf<Number>& s) {
  const PointOf<Number> u = point_of<Number>(from);
  const Number along[3] = {Number::difference(to.x, from.x), Number::difference(to.y, from.y),
                           Number::difference(to.z, from.z)};
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
    return line_plane_point<Number>(g.position(how.line_from), g.position(how.line_to),
                                    plane_at(how.c));
  return three_plane_point<Number>(plane_at(how.a), plane_at(how.b), plane_at(how.c));
}

}  // namespace sectile
