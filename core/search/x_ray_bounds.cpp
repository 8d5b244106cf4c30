#include "search/x_ray_bounds.h"

#include <cmath>
#include <limits>
#include <span>

#include "numbers/rounding.h"
#include "search/approximate.h"

namespace sectile {

using namespace approximate;
using rounding::underflow;
using rounding::unit;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

// Rounding to nearest is monotonic.
double XRayBounds::begin(const Box& b) const {
  const bool met = (b.low[1] <= start_.y) & (start_.y <= b.high[1]) & (b.low[2] <= start_.z) &
                   (start_.z <= b.high[2]) & (start_.x <= b.high[0]);
  return met ? b.low[0] : infinity;
}

// Between three pairs of parallel planes. As in apart(), slacks are for all errors of rounding, but
// that of the quotients.
double XRayBounds::begin(const OrientedBox& box) const {
  if (!slack_) slack_ = OrientedBox(std::span(&start_, 1)).slack;
  const double slack = 2 * (box.slack + *slack_);
  const Vec3 between = box.centre - start_;
  double from = 0, to = infinity;
  for (int i = 0; i < 3; ++i) {
    const double speed = std::abs(box.axis[i].x), reach = box.extent[i] + slack;
    const double away = dot(box.axis[i], between) * (box.axis[i].x < 0 ? -1 : 1);
    if (std::abs(away) > reach && (speed == 0 || away < 0)) return infinity;
    if (speed == 0) continue;
    const double first = (away - reach) / speed, last = (away + reach) / speed;
    if (first > from) from = first;
    if (last < to) to = last;
  }
  if (from * (1 - 8 * unit) > to * (1 + 8 * unit)) return infinity;
  return start_.x + from - 8 * unit * (std::abs(start_.x) + from);
}

// At start - F / n with F for the value of the plane's equation there; see Kernel::estimate().
XRayBounds::Stretch XRayBounds::meeting(const PlaneValue& plane) const {
  const double slope = std::abs(plane.n[0]), least = slope - plane.n_error;
  if (!(least > slope / 2) || !(slope > 0x1p-500)) return {-infinity, infinity};
  const double x = plane.n[0] * start_.x, y = plane.n[1] * start_.y, z = plane.n[2] * start_.z;
  const double sum = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(plane.d);
  const double size = std::abs(start_.x) + std::abs(start_.y) + std::abs(start_.z) + 4 * underflow;
  const double error = 12 * unit * sum + plane.d_error + plane.n_error * size * (1 + 8 * unit) +
                       underflow * (8 + slope + std::abs(plane.n[1]) + std::abs(plane.n[2]));
  const double way = -(x + y + z + plane.d) / plane.n[0];
  const double off = (error + std::abs(way) * plane.n_error) / least * (1 + 16 * unit) +
                     16 * unit * (std::abs(way) + std::abs(start_.x)) + underflow;
  if (!(off < infinity)) return {-infinity, infinity};
  return {start_.x + way - off, start_.x + way + off};
}

Sign x_of_normal(const PlaneValue& plane) {
  const double x = plane.n[0];
  return std::abs(x) > plane.n_error ? sign_of(x) : Sign::zero;
}

}  // namespace sectile
