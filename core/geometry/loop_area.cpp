#include "geometry/loop_area.h"

#include <algorithm>

#include "numbers/rounding.h"

namespace sectile {

Estimate LoopArea::estimate() const {
  using rounding::underflow, rounding::unit;
  const auto count = static_cast<double>(count_);
  // Positions near zero are off by half the least double.
  const double error = 16 * count * unit *
                           (count * extent_i_ * extent_j_ + size_i_ * extent_j_ +
                            size_j_ * extent_i_ + unit * size_i_ * size_j_) +
                       16 * count * underflow * (extent_i_ + extent_j_) + count * underflow;
  return {area_, error};
}

bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop) {
  const int k = kernel.main_axis(plane), i = (k + 1) % 3, j = (k + 2) % 3;
  const Sign up = kernel.normal(plane, k);
  LoopArea area(i, j);
  for (const PointId p : loop) area.add(kernel.geometry().position(p));
  if (area.estimate().decided()) return area.estimate().sign() == up;
  // At an extreme place all corners of a counter-clockwise loop are convex, and of a clockwise one
  // some is not.
  const auto before = [&](PointId p, PointId q) {
    const Sign sign = kernel.compare(p, q, i);
    return sign != Sign::zero ? sign == Sign::positive : kernel.compare(p, q, j) == Sign::positive;
  };
  const PointId extreme = *std::min_element(loop.begin(), loop.end(), before);
  for (std::size_t c = 0; c < loop.size(); ++c) {
    if (!kernel.same_point(loop[c], extreme)) continue;
    const PointId last = loop[c > 0 ? c - 1 : loop.size() - 1];
    const PointId next = loop[c + 1 < loop.size() ? c + 1 : 0];
    if (kernel.turn(last, loop[c], next, k) != up) return false;
  }
  return true;
}

}  // namespace sectile
