#include "geometry/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/axes.h"
#include "geometry/four_points.h"
#include "numbers/rounding.h"

namespace sectile {
namespace {

using rounding::underflow;
using rounding::unit;

// A point's position is off by half an ulp at most.
double position_error(double coordinate) {
  return unit * std::abs(coordinate) + underflow;
}

}  // namespace

const NearPlace& Probe::near() const {
  if (near_) return *near_;
  if (!point_.valid()) return near_.emplace(near_crossing());
  NearPlace place{kernel_.geometry().position(point_), {}};
  for (int k = 0; k < 3; ++k) component(place.error, k) = position_error(component(place.at, k));
  return near_.emplace(place);
}

// from + λ (to - from), where λ = |s| / (|s| + |t|) for the values s and t at both ends, which have
// different signs. With the true values s' and t', λ - λ' = (s t' - s' t) / ((s + t) (s' + t')):
// the larger error of s and t divided by s' + t', at most.
NearPlace Probe::near_crossing() const {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const double s = std::abs(at_from_.value), t = std::abs(at_to_.value), sum = s + t;
  NearPlace place{{}, {endless, endless, endless}};
  if (!(sum > 2 * (at_from_.error + at_to_.error)) || !(sum < endless)) return place;
  const double share = s / sum;
  const double doubt =
      (2 * std::max(at_from_.error, at_to_.error) / sum + 4 * unit) * (1 + 16 * unit);
  const Vec3 &from = kernel_.geometry().position(from_), &to = kernel_.geometry().position(to_);
  for (int k = 0; k < 3; ++k) {
    const double a = component(from, k), b = component(to, k), along = b - a;
    component(place.at, k) = a + share * along;
    component(place.error, k) =
        (doubt * std::abs(along) + 12 * unit * (std::abs(a) + std::abs(b)) + 8 * underflow) *
        (1 + 16 * unit);
  }
  return place;
}

Sign Probe::clear_turn(PointId p, PointId q, int axis) const {
  const int i = next_axis(axis), j = next_next_axis(axis);
  const Vec3 &a = kernel_.geometry().position(p), &b = kernel_.geometry().position(q);
  const NearPlace& c = near();
  const double ai = component(a, i), aj = component(a, j), bi = component(b, i),
               bj = component(b, j), ci = component(c.at, i), cj = component(c.at, j);
  const double left = (bi - ai) * (cj - aj), right = (bj - aj) * (ci - ai);
  const double hi =
      4 * unit * (std::abs(ai) + std::abs(bi)) + component(c.error, i) + 4 * underflow;
  const double hj =
      4 * unit * (std::abs(aj) + std::abs(bj)) + component(c.error, j) + 4 * underflow;
  const double error = 8 * unit * (std::abs(left) + std::abs(right)) + 8 * underflow +
                       2 * (hi * (std::abs(cj - aj) + std::abs(bj - aj) + hj) +
                            hj * (std::abs(bi - ai) + std::abs(ci - ai) + hi));
  const Estimate turn{left - right, error};
  return turn.decided() ? turn.sign() : Sign::zero;
}

std::optional<Sign> Probe::turn(PlaneId plane, PointId p, PointId q) const {
  if (point_.valid() || plane != how_.c) return {};
  const Geometry& g = kernel_.geometry();
  for (const PointId given : {from_, to_, p, q})
    if (!g.is_explicit(given)) return {};
  return side_of_three(g.position(from_), g.position(to_), g.position(p), g.position(q)) * to_side_;
}

const BoundedPoint& Probe::bounded() const {
  if (!bounded_) bounded_ = kernel_.bounded(how_);
  return *bounded_;
}

const ExactPoint& Probe::exact() const {
  if (point_.valid()) return kernel_.exact(point_);
  if (!exact_) exact_ = kernel_.exact(how_);
  return *exact_;
}

Sign Probe::side(PlaneId plane) const {
  if (point_.valid()) return kernel_.side(point_, plane);
  if (plane == how_.a || plane == how_.b || plane == how_.c) return Sign::zero;
  const Estimate u = kernel_.estimate(from_, plane), v = kernel_.estimate(to_, plane);
  // The crossing lies strictly between the two points.
  if (u.decided() && v.decided() && u.sign() == v.sign()) return u.sign();
  // (u·f(to) - v·f(from)) / (f(to) - f(from)) is the plane's value at the crossing.
  const Estimate &s = at_from_, &t = at_to_;
  const double left = u.value * t.value, right = v.value * s.value;
  const double error =
      4 * unit * (std::abs(left) + std::abs(right)) +
      2 * (std::abs(u.value) * t.error + std::abs(t.value) * u.error + u.error * t.error +
           std::abs(v.value) * s.error + std::abs(s.value) * v.error + s.error * v.error) +
      16 * underflow;
  const Estimate crossing{left - right, error};
  if (crossing.decided()) return crossing.sign() * to_side_;
  if (const auto known = kernel_.level_side(how_, plane)) return *known;
  const Bounded near = value_at(kernel_.bounded(plane), bounded());
  if (near.decided() && bounded().w.decided()) return near.sign() * bounded().w.sign();
  return value_at(kernel_.exact(plane), exact()).sign() * exact().w.sign();
}

const Vec3& Probe::position() const {
  if (point_.valid()) return kernel_.geometry().position(point_);
  if (!position_) position_ = kernel_.construct(how_).position;
  return *position_;
}

Sign Probe::compare(PointId q, int axis) const {
  if (point_.valid()) return kernel_.compare(point_, q, axis);
  const double y = component(kernel_.geometry().position(q), axis);
  if (!position_) {
    const double error = component(near().error, axis) + position_error(y);
    const Estimate ahead{y - component(near().at, axis),
                         error * (1 + 16 * unit) + 4 * unit * std::abs(y)};
    if (ahead.decided()) return ahead.sign();
    if (const auto u = kernel_.level(how_, axis), v = kernel_.level(q, axis); u && v)
      return sign_of(*v - *u);
  }
  const double x = component(position(), axis);
  if (x != y) return x < y ? Sign::positive : Sign::negative;
  const ExactPoint &u = exact(), &v = kernel_.exact(q);
  return minor(v.x[axis], v.w, u.x[axis], u.w).sign() * u.w.sign() * v.w.sign();
}

PointId add_constructed(Geometry& geometry, const Construction& how,
                        const ConstructedPoint& point) {
  return point.is_explicit ? geometry.add_point(point.position)
                           : geometry.add_point(how, point.position);
}

}  // namespace sectile
