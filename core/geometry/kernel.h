// The exact tests. Nothing else decides anything.
//
// Every test is a formula that is evaluated up to three times: in doubles with an error bound;
// then, if the operands' coefficients are doubles without error, as an exact sum of products; then
// in dyadic numbers of any length. The last always answers.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "geometry/geometry.h"
#include "numbers/dyadic.h"
#include "numbers/sign.h"

namespace sectile {

/// A plane's coefficients in doubles. The true ones differ by at most the errors.
struct PlaneValue {
  double n[3];
  double d;
  double n_error;  ///< bound for each component of the normal
  double d_error;
  bool exact;  ///< both errors are zero
};

/// A plane's exact coefficients.
struct ExactPlane {
  Dyadic n[3], d;
};

/// A point's exact homogeneous coordinates; w is never zero.
struct ExactPoint {
  Dyadic x, y, z, w;
};

PlaneValue plane_value(const Geometry& geometry, PlaneId plane);
ExactPlane exact_plane(const Geometry& geometry, PlaneId plane);
ExactPoint exact_point(const Geometry& geometry, PointId point);

/// A value known up to an error.
struct Estimate {
  double value, error;
  bool decided() const { return value > error || value < -error; }
  Sign sign() const { return sign_of(value); }
};

/// The tests for the points and planes of one geometry. Tests may run in many threads at a time;
/// refresh() may not run beside them.
class Kernel {
 public:
  explicit Kernel(const Geometry& geometry);
  ~Kernel();
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  /// Must be called after planes or points were added to the geometry.
  void refresh();
  /// Must be called after planes were changed.
  void refresh_all();
  const Geometry& geometry() const { return geometry_; }
  const PlaneValue& value(PlaneId s) const { return values_[s.value()]; }

  /// Positive: the point lies on the side to which the normal points.
  Sign side(PointId point, PlaneId plane) const;
  /// The value of the plane's equation at a point, in doubles.
  Estimate estimate(PointId point, PlaneId plane) const;
  /// The sign of the determinant of three normals.
  Sign det(PlaneId a, PlaneId b, PlaneId c) const;
  /// The sign of one component of normal(a) × normal(b).
  Sign cross(PlaneId a, PlaneId b, int axis) const;
  /// An axis on which normal(a) × normal(b) is not zero, or -1 if the planes are parallel.
  int cross_axis(PlaneId a, PlaneId b) const;
  bool parallel(PlaneId a, PlaneId b) const { return cross_axis(a, b) < 0; }
  /// The sign of one component of the normal.
  Sign normal(PlaneId a, int axis) const;
  /// An axis on which the normal is not zero: the one of the largest component.
  int main_axis(PlaneId a) const;
  /// For parallel planes: do the normals point to the same side?
  bool same_direction(PlaneId a, PlaneId b) const;
  /// The same plane, with equal or opposite normals.
  bool coplanar(PlaneId a, PlaneId b) const;
  /// p == q?
  bool same_point(PointId p, PointId q) const;
  /// The sign of q - p on one axis.
  Sign compare(PointId p, PointId q, int axis) const;
  /// The sign of ((q - p) × (r - p)) · e_axis: the turn p, q, r seen against an axis.
  Sign turn(PointId p, PointId q, PointId r, int axis) const;

  const ExactPlane& exact(PlaneId s) const;
  const ExactPoint& exact(PointId p) const;
  ExactPoint exact(const Construction& how) const;

 private:
  Sign exact_side(PointId point, PlaneId plane) const;

  const Geometry& geometry_;
  std::vector<PlaneValue> values_;
  mutable std::vector<std::atomic<const ExactPlane*>> exact_planes_;
  mutable std::vector<std::atomic<const ExactPoint*>> exact_points_;
};

}  // namespace sectile
