// An affine map of exact points, rounded once or not at all.
#pragma once

#include "geometry/kernel.h"
#include "sectile/transform.h"

namespace sectile {

/// a[0]·b[0] + … + a[3]·b[3], rounded to the nearest double; plain floating point if a factor is
/// not finite.
double rounded_dot(const double a[4], const double b[4]);

/// Exact images under an affine map.
class ExactAffine {
 public:
  /// Throws std::invalid_argument for a matrix that is singular or not finite.
  explicit ExactAffine(const Transform& transform);

  bool mirrors() const { return determinant_.sign() == Sign::negative; }
  /// The image of a point, rounded once.
  Vec3 rounded(const Vec3& point) const { return transform_(point); }
  Vec3 rounded(const ExactPoint& point) const;
  /// The image of an explicit point; false if the doubles cannot hold it.
  bool map(const Vec3& point, Vec3& image) const;
  /// The image of a plane a·x + b·y + c·z + d = 0 with its normal to the same side of the solid;
  /// false if the doubles cannot hold it.
  bool map(const PlaneCoefficients& plane, PlaneCoefficients& image) const;
  /// The axis to which an axis is mapped, and whether it is reversed; -1 if to none.
  int axis_image(int axis, bool& reversed) const;

 private:
  const Dyadic& entry(int row, int column) const { return entries_[4 * row + column]; }

  Transform transform_;
  Dyadic entries_[12];
  Dyadic cofactors_[9];  // of the linear part, row by row
  Dyadic determinant_;
};

}  // namespace sectile
