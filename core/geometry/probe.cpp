#include "geometry/probe.h"

#include <cmath>

namespace sectile {

Vec3 rounded(const ExactPoint& p) {
  return {nearest_quotient(p.x, p.w), nearest_quotient(p.y, p.w), nearest_quotient(p.z, p.w)};
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
      4 * 0x1p-53 * (std::abs(left) + std::abs(right)) +
      2 * (std::abs(u.value) * t.error + std::abs(t.value) * u.error + u.error * t.error +
           std::abs(v.value) * s.error + std::abs(s.value) * v.error + s.error * v.error) +
      8 * 4.9406564584124654e-324;
  const Estimate crossing{left - right, error};
  if (crossing.decided()) return crossing.sign() * to_side_;
  const ExactPlane& e = kernel_.exact(plane);
  const ExactPoint& p = exact();
  return (e.n[0] * p.x + e.n[1] * p.y + e.n[2] * p.z + e.d * p.w).sign() * p.w.sign();
}

const Vec3& Probe::position() const {
  if (point_.valid()) return kernel_.geometry().position(point_);
  if (!position_) position_ = rounded(exact());
  return *position_;
}

bool equals(const ExactPoint& e, const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
         (e.x - Dyadic(p.x) * e.w).sign() == Sign::zero &&
         (e.y - Dyadic(p.y) * e.w).sign() == Sign::zero &&
         (e.z - Dyadic(p.z) * e.w).sign() == Sign::zero;
}

namespace {

double on_axis(const Vec3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}
const Dyadic& on_axis(const ExactPoint& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

Sign Probe::compare(PointId q, int axis) const {
  if (point_.valid()) return kernel_.compare(point_, q, axis);
  const double x = on_axis(position(), axis), y = on_axis(kernel_.geometry().position(q), axis);
  if (x != y) return x < y ? Sign::positive : Sign::negative;
  const ExactPoint &u = exact(), &v = kernel_.exact(q);
  return (on_axis(v, axis) * u.w - on_axis(u, axis) * v.w).sign() * u.w.sign() * v.w.sign();
}

PointId add_constructed(Geometry& geometry, const Construction& how, const Vec3& position,
                        bool is_explicit) {
  return is_explicit ? geometry.add_point(position) : geometry.add_point(how, position);
}

}  // namespace sectile
