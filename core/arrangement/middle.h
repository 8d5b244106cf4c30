// The point half-way between two others, which is asked about and never kept.
#pragma once

#include <optional>
#include <utility>

#include "geometry/kernel.h"

namespace sectile::arrangement {

class Middle {
 public:
  Middle(const Kernel& kernel, PointId p, PointId q) : kernel_(kernel), p_(p), q_(q) {}

  /// Positive: it lies on the side to which the normal points.
  Sign side(PlaneId plane) const;
  /// The sign of r - (this point) on one axis.
  Sign compare(PointId r, int axis) const;
  /// Bounds of a coordinate; they hold for any point that is rounded to nearest, too, when it is
  /// compared with them.
  std::pair<double, double> bounds(int axis) const;

 private:
  const ExactPoint& exact() const;

  const Kernel& kernel_;
  PointId p_, q_;
  mutable std::optional<ExactPoint> exact_;
};

/// The centre of mass of a triangle; w is positive.
ExactPoint exact_centre(const Kernel& kernel, PointId p, PointId q, PointId r);

}  // namespace sectile::arrangement
