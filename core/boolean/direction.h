// Directions within the plane of a face, and the sectors of its corners (paper, figure 15).
#pragma once

#include "boolean/patch.h"
#include "geometry/kernel.h"

namespace sectile {

/// In a plane with normal n: the direction sense · (n × normal(across)), along the line in which
/// the plane `across` cuts it.
struct Direction {
  PlaneId across;
  Sign sense = Sign::positive;
  Direction operator-() const { return {across, -sense}; }
};

/// Positive: b is less than half a turn counter-clockwise of a, seen against the plane's normal.
inline Sign turn(const Kernel& kernel, PlaneId plane, Direction a, Direction b) {
  return a.sense * b.sense * kernel.det(plane, a.across, b.across);
}
/// Positive: d is less than half a turn counter-clockwise of where the point lies, as seen from the
/// line of d. With normals n, m of the plane and the one across, and the way e to the point:
/// e × (n × m) = n (e · m).
inline Sign turn_from(const Kernel& kernel, PointId point, Direction d) {
  return kernel.side(point, d.across) * d.sense;
}
/// For directions without a turn: do they agree (or are they opposite)?
bool same_way(const Kernel& kernel, PlaneId plane, Direction a, Direction b);

/// The direction from p to q, two points of a plane and of a plane across.
Direction direction_between(const Kernel& kernel, PlaneId plane, PlaneId across, PointId p,
                            PointId q);

/// The direction in which a half-edge runs, within the plane of its face.
Direction direction_of(const Kernel& kernel, const Patch& patch, HalfEdgeId h);

/// The half-edge before or after h in its loop, passing over null edges.
HalfEdgeId previous_with_length(const Brep& brep, HalfEdgeId h);
HalfEdgeId next_with_length(const Brep& brep, HalfEdgeId h);

enum class Within : std::uint8_t { outside, inside, along_first, along_last };

/// Where a direction from the start of h lies relative to the corner there, which reaches
/// counter-clockwise from h to the half-edge before it; equal bounds mean a full turn.
Within within_corner(const Kernel& kernel, const Patch& patch, HalfEdgeId h, Direction d);

/// Where a direction is on the way counter-clockwise from `start`: 0 along it, 1 less than half a
/// turn after it, 2 opposite, 3 more than half a turn.
int quarter(const Kernel& kernel, PlaneId plane, Direction start, Direction d);

/// Does a come before b on the way counter-clockwise from `start`? All three differ in direction,
/// except that a and b may be equal to the start.
bool before_counter_clockwise(const Kernel& kernel, PlaneId plane, Direction start, Direction a,
                              Direction b);

}  // namespace sectile
