// The area of a loop in a plane, and which way it turns.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/axes.h"
#include "geometry/kernel.h"

namespace sectile {

/// Twice the signed area of a loop's projection to the axes i and j, in doubles.
class LoopArea {
 public:
  LoopArea(int i, int j) : i_(i), j_(j) {}

  /// The next corner, rounded to nearest.
  void add(const Vec3& corner) {
    const double x = component(corner, i_), y = component(corner, j_);
    if (count_ == 0) {
      first_i_ = x;
      first_j_ = y;
    }
    const double di = x - first_i_, dj = y - first_j_;
    area_ += last_i_ * dj - last_j_ * di;
    extent_i_ = std::max(extent_i_, std::abs(di));
    extent_j_ = std::max(extent_j_, std::abs(dj));
    size_i_ = std::max(size_i_, std::abs(x));
    size_j_ = std::max(size_j_, std::abs(y));
    last_i_ = di;
    last_j_ = dj;
    ++count_;
  }

  /// With a bound for all rounding.
  Estimate estimate() const;

 private:
  int i_, j_;
  std::size_t count_ = 0;
  double first_i_ = 0, first_j_ = 0, area_ = 0;
  double last_i_ = 0, last_j_ = 0;  // relative to the first corner, as the extents
  double extent_i_ = 0, extent_j_ = 0, size_i_ = 0, size_j_ = 0;
};

/// Is a loop of a plane counter-clockwise, seen against the plane's normal? Neighbouring points
/// differ in place. Loops that touch themselves are allowed.
bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop);

}  // namespace sectile
