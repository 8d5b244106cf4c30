#include "search/along_line.h"

#include <cmath>
#include <limits>

#include "geometry/axes.h"
#include "numbers/rounding.h"
#include "search/directions.h"

namespace sectile {
namespace {

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

int longest_axis(const Vec3& d) {
  int axis = 0;
  for (const int k : {1, 2})
    if (std::abs(component(d, k)) > std::abs(component(d, axis))) axis = k;
  return axis;
}

}  // namespace

AlongLine::AlongLine(const Vec3& from, const Vec3& to) : from_(from) {
  const Vec3 d{to.x - from.x, to.y - from.y, to.z - from.z};
  axis_ = longest_axis(d);
  length_ = component(d, axis_);
  for (int k = 0; k < 2; ++k) slope_[k] = component(d, (axis_ + 1 + k) % 3) / length_;
  size_ = std::max(largest(from), largest(to));
}

// The line is a point, and each half-plane that it bounds is one direction.
Vec3 AlongLine::seen(const Vec3& p) const {
  const double along = component(p, axis_) - component(from_, axis_);
  const auto across = [&](int k) {
    const int axis = (axis_ + 1 + k) % 3;
    return component(p, axis) - component(from_, axis) - along * slope_[k];
  };
  return {across(0), across(1), 0};
}

// With m for the largest coordinate and u for a rounding: a difference of two rounded positions is
// off by 4 u m, a slope, which is at most 1, by 9 u m / length and a rounding. That makes less than
// 20 u m + 9 u m · along / length on each axis, if the length is not rounding errors itself.
double AlongLine::error(const Vec3& p) const {
  const double m = std::max(size_, largest(p));
  if (!(64 * rounding::unit * m < std::abs(length_)))
    return std::numeric_limits<double>::infinity();
  const double along = component(p, axis_) - component(from_, axis_);
  return 64 * rounding::unit * m * (1 + std::abs(along / length_));
}

// Of p and q as they are seen: of the sum or difference of two products of one coordinate each.
double AlongLine::error_of_products(const Vec3& p, const Vec3& q) const {
  const Vec3 u = seen(p), v = seen(q);
  const double of_u = std::abs(u.x) + std::abs(u.y), of_v = std::abs(v.x) + std::abs(v.y),
               off_u = error(p), off_v = error(q);
  return off_u * of_v + off_v * of_u + 2 * off_u * off_v + 4 * rounding::unit * of_u * of_v +
         rounding::underflow;
}

// The axes across are in the order in which the turn from one to the other is counter-clockwise,
// seen from where the axis along the line leads to.
Sign AlongLine::turn(const Vec3& from, const Vec3& to) const {
  const Vec3 u = seen(from), v = seen(to);
  const double turn = u.x * v.y - u.y * v.x;
  // Twice, as the bound was rounded, too.
  if (!(std::abs(turn) > 2 * error_of_products(from, to))) return Sign::zero;
  return sign_of(turn) * sign_of(length_);
}

// With c and s for what is in proportion to cosine and sine, c / (|c| + |s|): where both are off by
// e, it is by less than 3 e / (|c| + |s|) and some roundings.
AlongLine::Turned AlongLine::turned(const Vec3& from, const Vec3& to) const {
  const Vec3 u = seen(from), v = seen(to);
  const double along = u.x * v.x + u.y * v.y, across = u.x * v.y - u.y * v.x,
               whole = std::abs(along) + std::abs(across),
               off = 8 * error_of_products(from, to) / whole + 8 * rounding::unit;
  if (!(off < 1)) return {0, 1};
  return {along / whole, off};
}

// Rounding to nearest is monotonic.
Sign AlongLine::along(const Vec3& from, const Vec3& to) const {
  return sign_of(component(to, axis_) - component(from, axis_)) * sign_of(length_);
}

Box AlongLine::reach(std::span<const Vec3> on_line) const {
  Box box = Box::everything();
  Bounds bounds;
  for (const Vec3& p : on_line) bounds.add(p);
  const Box around = bounds.box();
  box.low[2] = around.low[axis_];
  box.high[2] = around.high[axis_];
  return box;
}

Box AlongLine::box(std::span<const Vec3> on_line, std::span<const Vec3> beside) const {
  Directions directions;
  for (const Vec3& p : beside) directions.add(seen(p), error(p));
  Box box = directions.box();
  Box extent = reach(on_line);
  if (!beside.empty()) {
    const Box more = reach(beside);
    extent.low[2] = std::min(extent.low[2], more.low[2]);
    extent.high[2] = std::max(extent.high[2], more.high[2]);
  }
  box.low[2] = extent.low[2];
  box.high[2] = extent.high[2];
  return box;
}

}  // namespace sectile
