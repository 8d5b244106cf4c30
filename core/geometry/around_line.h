// The order of half-planes around a line.
#pragma once

#include "geometry/kernel.h"

namespace sectile {

/// The part of a face on one side of a line: forward if the face, seen from outside, lies to the
/// left of one who goes along the line in its direction.
struct LineSide {
  PlaneId plane;
  bool forward = true;
};

/// For half-planes around one line, counter-clockwise, seen against its direction. Going around,
/// what is outside of the face comes after a forward half-plane and before a backward one.
class AroundLine {
 public:
  /// `axis`: one on which the line has an extent, `up` the sign of its direction there. Without an
  /// axis all planes are parallel.
  AroundLine(const Kernel& kernel, int axis, Sign up) : kernel_(&kernel), axis_(axis), up_(up) {}

  /// Positive: normal(a) × normal(b) has the direction of the line.
  Sign cross(PlaneId a, PlaneId b) const {
    return axis_ < 0 ? Sign::zero : kernel_->cross(a, b, axis_) * up_;
  }
  /// Positive: b is less than half a turn counter-clockwise of a.
  Sign turn(const LineSide& a, const LineSide& b) const {
    const Sign s = cross(a.plane, b.plane);
    return a.forward == b.forward ? s : -s;
  }
  /// For half-planes without a turn: are they the same one?
  bool same_way(const LineSide& a, const LineSide& b) const {
    return kernel_->same_direction(a.plane, b.plane) == (a.forward == b.forward);
  }
  bool tied(const LineSide& a, const LineSide& b) const {
    return turn(a, b) == Sign::zero && same_way(a, b);
  }
  /// Counter-clockwise from `start`: 0 for its own direction, 2 for the opposite one, 1 and 3 for
  /// what lies between.
  int quarter(const LineSide& start, const LineSide& side) const {
    const Sign s = turn(start, side);
    if (s == Sign::zero) return same_way(start, side) ? 0 : 2;
    return s == Sign::positive ? 1 : 3;
  }
  /// Does a come before b, counter-clockwise from `start`? If they are one, `tie` is the answer.
  bool before(const LineSide& start, const LineSide& a, const LineSide& b, bool tie) const {
    const int in_a = quarter(start, a), in_b = quarter(start, b);
    if (in_a != in_b) return in_a < in_b;
    const Sign s = turn(a, b);
    return s != Sign::zero ? s == Sign::positive : tie;
  }

 private:
  const Kernel* kernel_;
  int axis_;
  Sign up_;
};

}  // namespace sectile
