#include "selftest/triangle_chord.h"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/axes.h"
#include "numbers/rounding.h"

namespace sectile {
namespace {

using rounding::underflow;
using rounding::unit;

PointOf<Bounded> bounded_point(const Kernel& kernel, PointId p) {
  const Geometry& g = kernel.geometry();
  return g.is_constructed(p) ? kernel.bounded(g.construction(p)) : given_point<Bounded>(g, p);
}

// Numbers of one kind for points and planes.
struct InBounds {
  using Number = Bounded;
  const Kernel& kernel;
  PointOf<Bounded> point(PointId p) const { return bounded_point(kernel, p); }
  const BoundedPlane& plane(PlaneId s) const { return kernel.bounded(s); }
};
struct Exactly {
  using Number = Dyadic;
  const Kernel& kernel;
  const ExactPoint& point(PointId p) const { return kernel.exact(p); }
  const ExactPlane& plane(PlaneId s) const { return kernel.exact(s); }
};

// side(v)·u - side(u)·v is on the line of u and v, and on the plane.
template <class Numbers>
PointOf<typename Numbers::Number> place(const Numbers& numbers, const ChordEnd& end) {
  const auto& u = numbers.point(end.from);
  if (end.from == end.to) return u;
  const auto& v = numbers.point(end.to);
  const auto& plane = numbers.plane(end.across);
  const auto side_u = value_at(plane, u), side_v = value_at(plane, v);
  PointOf<typename Numbers::Number> made;
  for (int k = 0; k < 3; ++k) made.x[k] = side_v * u.x[k] - side_u * v.x[k];
  made.w = side_v * u.w - side_u * v.w;
  return made;
}

template <class Number>
Number order(const PointOf<Number>& p, const PointOf<Number>& q, int axis) {
  return q.x[axis] * p.w - p.x[axis] * q.w;
}

// Bounds of a size that is known up to an error.
std::pair<double, double> size_of(const Estimate& e) {
  const double size = std::abs(e.value);
  return {std::max(0.0, (size - e.error) * (1 - 4 * unit)), (size + e.error) * (1 + 4 * unit)};
}

Vec3 between(const Vec3& u, const Vec3& v, double t) {
  return {u.x + t * (v.x - u.x), u.y + t * (v.y - u.y), u.z + t * (v.z - u.z)};
}

}  // namespace

ChordEnd ChordFinder::corner(PointId p) const {
  const Vec3& near = kernel_.geometry().position(p);
  const double at = component(near, axis_);
  if (kernel_.geometry().is_explicit(p)) return {p, p, PlaneId(), at, at, near};
  const double doubt = 2 * unit * std::abs(at) + 2 * underflow;
  return {p, p, PlaneId(), at - doubt, at + doubt, near};
}

ChordEnd ChordFinder::crossing(PointId from, PointId to, PlaneId plane) const {
  const Geometry& g = kernel_.geometry();
  const Vec3 &u = g.position(from), &v = g.position(to);
  const auto [least_u, most_u] = size_of(kernel_.estimate(from, plane));
  const auto [least_v, most_v] = size_of(kernel_.estimate(to, plane));
  // Which part of the way lies before the plane.
  const double least = least_u / (least_u + most_v) * (1 - 8 * unit);
  const double most = std::min(1.0, most_u / (most_u + least_v) * (1 + 8 * unit));
  const double at_u = component(u, axis_), at_v = component(v, axis_);
  const double first = at_u + least * (at_v - at_u), last = at_u + most * (at_v - at_u);
  const double doubt = 16 * unit * (std::abs(at_u) + std::abs(at_v)) + 16 * underflow;
  ChordEnd end{from, to, plane, std::min(first, last) - doubt, std::max(first, last) + doubt, u};
  if (std::isfinite(end.low) && std::isfinite(end.high)) {
    end.near = between(u, v, (least + most) / 2);
  } else {
    end.high = std::numeric_limits<double>::infinity();
    end.low = -end.high;
  }
  return end;
}

Chord ChordFinder::find(const std::array<PointId, 3>& corners, const std::array<Sign, 3>& sides,
                        PlaneId plane) const {
  Chord chord;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k < 2 ? k + 1 : 0;
    if (sides[k] == Sign::zero) {
      if (sides[next] == Sign::zero) chord.edge = static_cast<int>(k);
      chord.ends[count++] = corner(corners[k]);
    } else if (sides[k] == -sides[next]) {
      chord.ends[count++] = crossing(corners[k], corners[next], plane);
    }
  }
  if (compare(chord.ends[0], chord.ends[1]) == Sign::negative)
    std::swap(chord.ends[0], chord.ends[1]);
  return chord;
}

Sign ChordFinder::compare(const ChordEnd& a, const ChordEnd& b) const {
  if (a.high < b.low) return Sign::positive;
  if (b.high < a.low) return Sign::negative;
  if (a.from == a.to && b.from == b.to) return kernel_.compare(a.from, b.from, axis_);
  const InBounds bounds{kernel_};
  const auto near_a = place(bounds, a), near_b = place(bounds, b);
  const Bounded near = order(near_a, near_b, axis_);
  if (near.decided() && near_a.w.decided() && near_b.w.decided())
    return near.sign() * near_a.w.sign() * near_b.w.sign();
  const Exactly exactly{kernel_};
  const auto p = place(exactly, a), q = place(exactly, b);
  return order(p, q, axis_).sign() * p.w.sign() * q.w.sign();
}

}  // namespace sectile
