// The numbers that coordinates may be.
#pragma once

#include "sectile/mesh.h"
#include "sectile/rounding.h"

namespace sectile {

/// The multiple of a spacing nearest to a value, as the nearest double.
double nearest_multiple(double value, double spacing);

class RoundingGrid {
 public:
  /// Throws Error if the spacing is no positive number.
  explicit RoundingGrid(const Rounding& rounding);

  bool has_all_doubles() const { return numbers_ == Rounding::Numbers::doubles; }
  double nearest(double value) const;
  Vec3 nearest(const Vec3& p) const {
    return has_all_doubles() ? p : Vec3{nearest(p.x), nearest(p.y), nearest(p.z)};
  }
  /// The distance between numbers of the size of the point's largest coordinate.
  double step(const Vec3& p) const;

 private:
  Rounding::Numbers numbers_;
  double spacing_;
};

}  // namespace sectile
