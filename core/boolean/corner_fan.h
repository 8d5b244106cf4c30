// Very many corners that one face has in one point, by direction: which of them a direction is in
// is looked up.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/direction.h"

namespace sectile {

class CornerFan {
 public:
  /// Where a corner begins, counter-clockwise, or ends.
  struct Bound {
    Direction direction;
    HalfEdgeId h;  ///< that runs there
    bool begins;   ///< so it leaves the point
    std::uint8_t quarter;
  };
  /// Numbers of bounds, cyclic: last may be less than first.
  struct Range {
    std::size_t first, count;
  };

  /// Of the half-edges of one face that leave the point, at least one.
  CornerFan(const Kernel& kernel, const Patch& patch, std::span<const HalfEdgeId> leaving);

  std::size_t size() const { return bounds_.size(); }
  const Bound& operator[](std::size_t i) const { return bounds_[i % bounds_.size()]; }

  /// The last bound on the way counter-clockwise to a direction, or in it.
  const Bound& last(const Kernel& kernel, Direction d) const;
  /// Those in a direction.
  Range along(const Kernel& kernel, Direction d) const;
  /// Those in the directions of the places of an edge of the plane that does not end in the point.
  Range towards(const Kernel& kernel, PointId from, PointId to) const;

 private:
  struct Gap {
    std::size_t before, behind;  // those that come before it, and these with those in it
  };
  template <class TurnTo>
  Gap gap(int quarter, const TurnTo& turn_to) const;
  Gap gap(const Kernel& kernel, Direction d) const;
  Gap gap(const Kernel& kernel, PointId p) const;

  PlaneId plane_;
  PointId point_;
  std::vector<Bound> bounds_;  // counter-clockwise from the first; in one direction ends first
};

}  // namespace sectile
