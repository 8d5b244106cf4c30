// Point in polygon by counting the crossings of a ray, exactly.
#pragma once

#include "geometry/kernel.h"

namespace sectile {

/// Counts crossings of the ray in direction +i within the projection along a plane's main axis k,
/// with coordinates (i, j) and half-open edges. `Point` is a point of the plane that can be asked
/// for compare(PointId, axis) and side(PlaneId), as a Probe can.
template <class Point>
class PlanarRay {
 public:
  /// What an edge has in common with the point.
  enum class Touch { nothing, from, to, within };

  PlanarRay(const Kernel& kernel, PlaneId plane, const Point& point)
      : kernel_(&kernel),
        plane_(plane),
        point_(&point),
        k_(kernel.main_axis(plane)),
        i_((k_ + 1) % 3),
        j_((k_ + 2) % 3) {}

  int i() const { return i_; }
  int j() const { return j_; }
  /// After all edges of a face, none of which touches the point: is it inside?
  bool odd() const { return odd_; }

  /// A stretch of a loop from u to v that meets the line of the ray on the ray only, and not in the
  /// point.
  void pass(PointId u, PointId v) {
    const bool u_below = point_->compare(u, j_) == Sign::negative,
               v_below = point_->compare(v, j_) == Sign::negative;
    if (u_below != v_below) odd_ = !odd_;
  }

  /// Nothing was counted.
  void restart() { odd_ = false; }

  /// Where the ray leaves, or comes into, what is on the left of an edge from u to v that it
  /// crosses before any other edge of the face: then that is all that counts.
  void cross_first(PointId u) {
    const bool up = point_->compare(u, j_) == Sign::negative;
    odd_ = up != is_mirrored();
  }

  /// An edge from u to v, with the face on its left; across() gives a plane through it that is not
  /// parallel to the face's.
  template <class Across>
  Touch add(PointId u, PointId v, const Across& across) {
    // Edges of a loop come one after the other, as a rule.
    const Sign ju = u == last_ ? level_of_last_ : point_->compare(u, j_);
    const Sign jv = point_->compare(v, j_);
    last_ = v;
    level_of_last_ = jv;
    if (ju != Sign::zero && ju == jv) return Touch::nothing;
    if (ju == Sign::zero && point_->compare(u, i_) == Sign::zero) return Touch::from;
    if (jv == Sign::zero && point_->compare(v, i_) == Sign::zero) return Touch::to;
    if (ju == Sign::zero && jv == Sign::zero)
      return point_->compare(u, i_) != point_->compare(v, i_) ? Touch::within : Touch::nothing;
    // Half-open: a point level with the line counts as above it.
    const bool up = ju == Sign::negative && jv != Sign::negative;
    const bool down = jv == Sign::negative && ju != Sign::negative;
    if (ju == Sign::zero || jv == Sign::zero) {
      if ((up || down) && point_->compare(ju == Sign::zero ? u : v, i_) == Sign::positive)
        odd_ = !odd_;
      return Touch::nothing;
    }
    const Sign turn = turn_along(u, v, up, across);
    if (turn == Sign::zero) return Touch::within;
    if (((turn == Sign::positive) != is_mirrored()) == up) odd_ = !odd_;
    return Touch::nothing;
  }

 private:
  bool is_mirrored() const { return kernel_->normal(plane_, k_) == Sign::negative; }

  // Is the point to the left of an edge that goes up or down past it?
  template <class Across>
  Sign turn_along(PointId u, PointId v, bool up, const Across& across) const {
    if constexpr (requires { point_->turn(plane_, u, v); })
      if (const auto turn = point_->turn(plane_, u, v)) return *turn;
    const PlaneId plane = across();
    // The edge runs along sense · (n × normal(plane)); its left side has the sign -sense.
    const Sign sense = (up ? Sign::positive : Sign::negative) * kernel_->cross(plane_, plane, j_);
    return -(point_->side(plane) * sense);
  }

  const Kernel* kernel_;
  PlaneId plane_;
  const Point* point_;
  int k_, i_, j_;
  bool odd_ = false;
  PointId last_;  // where the last edge ended
  Sign level_of_last_ = Sign::zero;
};

}  // namespace sectile
