#include "arrangement/middle.h"

#include <algorithm>
#include <cmath>

#include "numbers/rounding.h"

namespace sectile::arrangement {
namespace {

// The sum of points as vectors; the weights are multiplied.
ExactPoint sum(const ExactPoint& p, const ExactPoint& q) {
  ExactPoint s;
  for (int k = 0; k < 3; ++k) s.x[k] = p.x[k] * q.w + q.x[k] * p.w;
  s.w = p.w * q.w;
  return s;
}

ExactPoint with_positive_weight(ExactPoint p) {
  if (p.w.sign() == Sign::positive) return p;
  for (Dyadic& x : p.x) x = -x;
  p.w = -p.w;
  return p;
}

}  // namespace

const ExactPoint& Middle::exact() const {
  if (!exact_) {
    ExactPoint s = sum(kernel_.exact(p_), kernel_.exact(q_));
    s.w = s.w * Dyadic(2.0);
    exact_ = with_positive_weight(s);
  }
  return *exact_;
}

Sign Middle::side(PlaneId plane) const {
  const Sign s = kernel_.side(p_, plane), t = kernel_.side(q_, plane);
  if (s == t || t == Sign::zero) return s;
  if (s == Sign::zero) return t;
  return value_at(kernel_.exact(plane), exact()).sign();
}

Sign Middle::compare(PointId r, int axis) const {
  const Sign s = kernel_.compare(p_, r, axis), t = kernel_.compare(q_, r, axis);
  if (s == t || t == Sign::zero) return s;
  if (s == Sign::zero) return t;
  const ExactPoint &m = exact(), &v = kernel_.exact(r);
  return minor(v.x[axis], v.w, m.x[axis], m.w).sign() * v.w.sign();
}

// Both ends are off by half an ulp, their halves' sum by another one, and what it is compared with
// by half an ulp of its own: two of the larger end in all.
std::pair<double, double> Middle::bounds(int axis) const {
  const Geometry& g = kernel_.geometry();
  const double p = component(g.position(p_), axis), q = component(g.position(q_), axis);
  const double middle = 0.5 * p + 0.5 * q;
  const double error = 8 * rounding::unit * std::max(std::abs(p), std::abs(q)) + 0x1p-1000;
  return {std::max(std::min(p, q), middle - error), std::min(std::max(p, q), middle + error)};
}

ExactPoint exact_centre(const Kernel& kernel, PointId p, PointId q, PointId r) {
  ExactPoint s = sum(sum(kernel.exact(p), kernel.exact(q)), kernel.exact(r));
  s.w = s.w * Dyadic(3.0);
  return with_positive_weight(s);
}

}  // namespace sectile::arrangement
