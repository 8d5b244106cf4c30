// Moves that bring corners of solids together exactly: places are compared as exact sums, and
// placements hold what a double cannot.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

/// A sum of corners of solids where they stand, each times a factor; nothing is rounded.
class ExactSum {
 public:
  ExactSum() = default;
  /// One corner in a solid's own coordinates, and where the solid stands.
  ExactSum(const ExactTransform& place, const ExactCorner& corner) { add(place, corner, 1); }
  static ExactSum of(const Vec3& point) { return {ExactTransform(), {point}}; }
  ExactSum& add(const ExactTransform& place, const ExactCorner& corner, double factor);
  ExactSum& add(const ExactSum& more, double factor);
  ExactSum mapped(const ExactTransform& by) const;  ///< where a map takes each of the corners
  /// Each coordinate is rounded once: zero only if it is zero.
  Vec3 value() const;
  /// Are all corners exact in what counts for this coordinate?
  bool is_known(int axis) const;

 private:
  struct Term {
    ExactTransform place;
    ExactCorner corner;
    double factor;
  };
  std::vector<Term> terms_;
};

using Coordinates = std::array<bool, 3>;

/// Are two sums of corners one point, as far as these coordinates go? False where it is not known.
bool are_equal(const ExactSum& a, const ExactSum& b, const Coordinates& axes);

struct Landing {
  Placement placement;
  bool is_exact = false;  ///< the wanted coordinates are reached exactly
};

/// The placement moved so that `parent` · placement maps `own` onto `target`, as far as these
/// coordinates go; exact if there is a position that a sum of two doubles can hold. Both are sums
/// whose factors make 1. For parents that are turned by other than right angles, positions may
/// exist that are not found.
Landing moved_onto(const Placement& start, const ExactTransform& parent, const ExactSum& own,
                   const ExactSum& target, const Coordinates& axes = {true, true, true});

/// A move in the coordinates of a placement: `by` + `rest`.
struct Shift {
  Vec3 by, rest;
};
Shift shift_between(const Placement& from, const Placement& to);
Placement shifted(const Placement& start, const Shift& shift);

/// A placement that means the same in another parent; exact if neither is turned.
Placement carried_over(const Placement& placement, const ExactTransform& from,
                       const ExactTransform& to);

}  // namespace sectile::viewer
