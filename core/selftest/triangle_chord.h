// Where a triangle meets the plane of another one: a chord, whose ends have an order along the line
// of both planes.
#pragma once

#include <array>

#include "geometry/kernel.h"

namespace sectile {

/// A corner of a triangle on the plane, or the point in which an edge goes through it.
struct ChordEnd {
  PointId from, to;  ///< the same for a corner
  PlaneId across;
  double low = 0, high = 0;  ///< the coordinate on the axis is between them
  Vec3 near;                 ///< the place, in doubles
};

struct Chord {
  std::array<ChordEnd, 2> ends;  ///< the second one is not before the first one
  int edge = -1;                 ///< the triangle's edge that is the chord, if it is one
};

class ChordFinder {
 public:
  /// `axis`: one on which the line has an extent.
  ChordFinder(const Kernel& kernel, int axis) : kernel_(kernel), axis_(axis) {}

  /// `sides`: those of the plane on which the corners lie. They lie on both sides, or two of them
  /// on the plane.
  Chord find(const std::array<PointId, 3>& corners, const std::array<Sign, 3>& sides,
             PlaneId plane) const;
  /// The sign of b - a on the axis.
  Sign compare(const ChordEnd& a, const ChordEnd& b) const;
  bool overlap(const Chord& a, const Chord& b) const {
    return compare(a.ends[0], b.ends[1]) == Sign::positive &&
           compare(b.ends[0], a.ends[1]) == Sign::positive;
  }

 private:
  ChordEnd corner(PointId p) const;
  ChordEnd crossing(PointId from, PointId to, PlaneId plane) const;

  const Kernel& kernel_;
  int axis_;
};

}  // namespace sectile
