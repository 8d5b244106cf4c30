// The exact tests. Nothing else decides anything.
//
// Every test is a formula that is evaluated up to three times: in doubles with an error bound; in
// pairs of doubles with an error bound, or, if the operands' coefficients are doubles without
// error, as an exact sum of products; in dyadic numbers of any length. The last always answers.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "geometry/formulas.h"
#include "geometry/plane_value.h"
#include "numbers/bounded.h"
#include "numbers/dyadic.h"
#include "numbers/sign.h"

namespace sectile {

using ExactPlane = PlaneOf<Dyadic>;
using ExactPoint = PointOf<Dyadic>;
using BoundedPlane = PlaneOf<Bounded>;
using BoundedPoint = PointOf<Bounded>;

/// Where a construction leads.
struct ConstructedPoint {
  Vec3 position;     ///< rounded to nearest
  bool is_explicit;  ///< the position is exact
};

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
  /// For tests that hardly ever ask about planes other than some: of the others doubles tell
  /// nothing.
  Kernel(const Geometry& geometry, std::span<const PlaneId> some);
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
  Estimate estimate(PointId point, PlaneId plane) const {
    return estimate(geometry_.position(point), plane);
  }
  /// The same for a point that is known up to half an ulp in each coordinate.
  Estimate estimate(const Vec3& rounded, PlaneId plane) const;
  /// See turn(), for points that are `exact` or known up to half an ulp in each coordinate.
  static Estimate estimated_turn(const Vec3& p, const Vec3& q, const Vec3& r, int axis, bool exact);
  /// The sign of the determinant of three normals.
  Sign det(PlaneId a, PlaneId b, PlaneId c) const;
  /// The sign of one component of normal(a) × normal(b).
  Sign cross(PlaneId a, PlaneId b, int axis) const;
  struct AxisSign {
    int axis;  ///< 0, 1, 2
    Sign sign;
  };
  /// An axis on which normal(a) × normal(b) is not zero, and the sign there; -1 and zero if the
  /// planes are parallel.
  AxisSign main_cross(PlaneId a, PlaneId b) const;
  int cross_axis(PlaneId a, PlaneId b) const { return main_cross(a, b).axis; }
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
  /// Of three points on a line: does p lie strictly between the others?
  bool is_between(PointId from, PointId p, PointId to) const;
  /// The sign of ((q - p) × (r - p)) · e_axis: the turn p, q, r seen against an axis.
  Sign turn(PointId p, PointId q, PointId r, int axis) const;

  /// One coordinate, where it is a double that is known without arithmetic: it is the same all
  /// along the line of the construction, or on one of its planes.
  std::optional<double> level(const Construction& how, int axis) const;
  std::optional<double> level(PointId p, int axis) const;
  /// Positive: on the side to which the normal points. Of a plane across an axis, where the
  /// coordinate is known.
  std::optional<Sign> level_side(const Construction& how, PlaneId plane) const;

  const ExactPlane& exact(PlaneId s) const;
  const ExactPoint& exact(PointId p) const;
  ExactPoint exact(const Construction& how) const;
  const BoundedPlane& bounded(PlaneId s) const;
  BoundedPoint bounded(const Construction& how) const;
  ConstructedPoint construct(const Construction& how) const;

 private:
  void make_room();
  std::optional<Vec3> along_axis(const Construction& how) const;
  std::array<Bounded, 3> bounded_place(const Construction& how) const;
  Sign exact_side(PointId point, PlaneId plane) const;
  // Component `largest` of normal(a) × normal(b), the largest one as far as doubles tell.
  Estimate estimated_cross(PlaneId a, PlaneId b, int& largest) const;

  const Geometry& geometry_;
  std::vector<PlaneValue> values_;
  mutable std::vector<std::atomic<const BoundedPlane*>> bounded_planes_;
  mutable std::vector<std::atomic<const ExactPlane*>> exact_planes_;
  mutable std::vector<std::atomic<const ExactPoint*>> exact_points_;
};

}  // namespace sectile
