#include "geometry/probe.h"

#include <cmath>

#include "numbers/rounding.h"

namespace sectile {

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
      4 * rounding::unit * (std::abs(left) + std::abs(right)) +
      2 * (std::abs(u.value) * t.error + std::abs(t.value) * u.error + u.error * t.error +
           std::abs(v.value) * s.error + std::abs(s.value) * v.error + s.error * v.error) +
      16 * rounding::smallest;
  const Estimate crossing{left - right, error};
  if (crossing.decided()) return crossing.sign() * to_side_;
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
  const double x = component(position(), axis), y = component(kernel_.geometry().position(q), axis);
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
