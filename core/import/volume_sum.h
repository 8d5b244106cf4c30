// The volume that triangles enclose, in doubles with a bound of all rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/four_points.h"
#include "numbers/rounding.h"

namespace sectile {

/// Six times the volume between triangles with exact corners and an origin.
class VolumeSum {
 public:
  void add(const Vec3& o, const NormalOfThree& triangle) {
    const Vec3& a = triangle.corner;
    const double p[3] = {a.x - o.x, a.y - o.y, a.z - o.z};
    double term = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      term += p[k] * triangle.normal[k];
      weight_ += std::abs(p[k]) * triangle.size[k];
      reach_ = std::max(reach_, std::abs(p[k]));
    }
    value_ += term;
    size_ += std::abs(term);
    ++terms_;
  }
  void add(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
    add(o, NormalOfThree(a, b, c));
  }
  friend VolumeSum operator+(const VolumeSum& a, const VolumeSum& b) {
    VolumeSum sum;
    sum.value_ = a.value_ + b.value_;
    sum.size_ = a.size_ + b.size_;
    sum.weight_ = a.weight_ + b.weight_;
    sum.reach_ = std::max(a.reach_, b.reach_);
    sum.terms_ = a.terms_ + b.terms_;
    return sum;
  }

  double value() const { return value_; }
  /// Three differences, two products and three sums make less than nine roundings of half an ulp of
  /// what the products of a term sum up to, and each of n terms is added n times at most; twice
  /// that, for those of this sum itself. A product that underflows is off by the least double times
  /// the third factor. Not finite where the value is not.
  double error() const {
    return 2 * rounding::unit * (terms_ * size_ + 9 * weight_) +
           rounding::underflow * terms_ * (1 + reach_);
  }

 private:
  double value_ = 0, size_ = 0, weight_ = 0, reach_ = 0, terms_ = 0;
};

}  // namespace sectile
