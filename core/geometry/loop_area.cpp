#include "geometry/loop_area.h"

#include <algorithm>
#include <cmath>

#include "geometry/axes.h"
#include "numbers/rounding.h"

namespace sectile {

Estimate estimated_area(const Geometry& geometry, const std::vector<PointId>& loop, int i, int j) {
  const Vec3& origin = geometry.position(loop[0]);
  double area = 0, extent_i = 0, extent_j = 0, size_i = 0, size_j = 0;
  double last_i = 0, last_j = 0;
  for (const PointId p : loop) {
    const double x = component(geometry.position(p), i), y = component(geometry.position(p), j);
    const double di = x - component(origin, i), dj = y - component(origin, j);
    area += last_i * dj - last_j * di;
    extent_i = std::max(extent_i, std::abs(di));
    extent_j = std::max(extent_j, std::abs(dj));
    size_i = std::max(size_i, std::abs(x));
    size_j = std::max(size_j, std::abs(y));
    last_i = di;
    last_j = dj;
  }
  using rounding::underflow, rounding::unit;
  const auto count = static_cast<double>(loop.size());
  // Positions near zero are off by half the least double.
  const double error = 16 * count * unit *
                           (count * extent_i * extent_j + size_i * extent_j + size_j * extent_i +
                            unit * size_i * size_j) +
                       16 * count * underflow * (extent_i + extent_j) + count * underflow;
  return {area, error};
}

bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop) {
  const int k = kernel.main_axis(plane), i = (k + 1) % 3, j = (k + 2) % 3;
  const Sign up = kernel.normal(plane, k);
  const Estimate area = estimated_area(kernel.geometry(), loop, i, j);
  if (area.decided()) return area.sign() == up;
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
