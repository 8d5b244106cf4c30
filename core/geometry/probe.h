// A point that is asked about before it is worth a place in the tables: a point of the geometry, or
// the crossing of a line between two points with a plane.
#pragma once

#include <optional>

#include "geometry/kernel.h"

namespace sectile {

/// A place as far as doubles know it: each coordinate is off by its error at most.
struct NearPlace {
  Vec3 at, error;
};

class Probe {
 public:
  Probe(const Kernel& kernel, PointId point) : kernel_(kernel), point_(point) {}
  /// The points lie strictly on different sides of plane how.c, on the line how.a ∩ how.b.
  Probe(const Kernel& kernel, PointId from, PointId to, const Construction& how)
      : kernel_(kernel),
        from_(from),
        to_(to),
        how_(how),
        at_from_(kernel.estimate(from, how.c)),
        at_to_(kernel.estimate(to, how.c)),
        to_side_(at_to_.decided() ? at_to_.sign() : kernel.side(to, how.c)) {}

  /// Positive: it lies on the side to which the normal points.
  Sign side(PlaneId plane) const;
  /// The sign of q - (this point) on one axis.
  Sign compare(PointId q, int axis) const;
  /// The sign of ((q - p) × (this point - p)) · e_axis; zero if doubles do not tell. Unlike side(),
  /// it asks for no second plane, which may be nearly parallel to the one that the point is in.
  Sign clear_turn(PointId p, PointId q, int axis) const;
  /// Of a crossing with the plane in which p and q are: the turn from p to q to it, as seen from
  /// where the normal points, positive to the left. That takes nothing but the ends of both lines;
  /// nothing where they are not three doubles each.
  std::optional<Sign> turn(PlaneId plane, PointId p, PointId q) const;
  /// Rounded to nearest.
  const Vec3& position() const;

 private:
  const NearPlace& near() const;
  NearPlace near_crossing() const;
  const BoundedPoint& bounded() const;
  const ExactPoint& exact() const;

  const Kernel& kernel_;
  PointId point_, from_, to_;
  Construction how_;
  Estimate at_from_{}, at_to_{};
  Sign to_side_ = Sign::zero;
  mutable std::optional<NearPlace> near_;
  mutable std::optional<BoundedPoint> bounded_;
  mutable std::optional<ExactPoint> exact_;
  mutable std::optional<Vec3> position_;
};

/// Adds the point of a construction, as an explicit one if it is three doubles.
PointId add_constructed(Geometry& geometry, const Construction& how, const ConstructedPoint& point);

}  // namespace sectile
