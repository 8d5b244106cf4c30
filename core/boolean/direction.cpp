#include "boolean/direction.h"

namespace sectile {

bool same_way(const Kernel& kernel, PlaneId plane, Direction a, Direction b) {
  const auto [axis, sign] = kernel.main_cross(plane, a.across);
  return sign * a.sense == kernel.cross(plane, b.across, axis) * b.sense;
}

Direction direction_between(const Kernel& kernel, PlaneId plane, PlaneId across, PointId p,
                            PointId q) {
  const auto [axis, sign] = kernel.main_cross(plane, across);
  return {across, kernel.compare(p, q, axis) * sign};
}

Direction direction_of(const Kernel& kernel, const Patch& patch, HalfEdgeId h) {
  const Brep& brep = patch.brep;
  return direction_between(kernel, brep.plane_of(h), patch.side(h), brep.point_of(brep.from(h)),
                           brep.point_of(brep.to(h)));
}

HalfEdgeId previous_with_length(const Brep& brep, HalfEdgeId h) {
  do h = brep.prev_of(h);
  while (brep.point_of(brep.from(h)) == brep.point_of(brep.to(h)));
  return h;
}

HalfEdgeId next_with_length(const Brep& brep, HalfEdgeId h) {
  do h = brep.next_of(h);
  while (brep.point_of(brep.from(h)) == brep.point_of(brep.to(h)));
  return h;
}

Within within_corner(const Kernel& kernel, const Patch& patch, HalfEdgeId h, Direction d) {
  const Brep& brep = patch.brep;
  const HalfEdgeId before = previous_with_length(brep, h);
  const PlaneId plane = brep.plane_of(h);
  const auto first = [&] { return direction_of(kernel, patch, h); };
  const auto last = [&] { return -direction_of(kernel, patch, before); };
  const Sign from_first = turn_from(kernel, brep.point_of(brep.to(h)), d),
             to_last = -turn_from(kernel, brep.point_of(brep.from(before)), d);
  if (from_first == Sign::zero && same_way(kernel, plane, first(), d)) return Within::along_first;
  if (to_last == Sign::zero && same_way(kernel, plane, last(), d)) return Within::along_last;
  if (from_first == to_last && from_first != Sign::zero)
    return from_first == Sign::positive ? Within::inside : Within::outside;
  return turn(kernel, plane, first(), last()) == Sign::positive ? Within::outside : Within::inside;
}

int quarter(const Kernel& kernel, PlaneId plane, Direction start, Direction d) {
  switch (turn(kernel, plane, start, d)) {
    case Sign::positive:
      return 1;
    case Sign::negative:
      return 3;
    case Sign::zero:
      break;
  }
  return same_way(kernel, plane, start, d) ? 0 : 2;
}

bool before_counter_clockwise(const Kernel& kernel, PlaneId plane, Direction start, Direction a,
                              Direction b) {
  const int in_a = quarter(kernel, plane, start, a), in_b = quarter(kernel, plane, start, b);
  if (in_a != in_b) return in_a < in_b;
  return turn(kernel, plane, a, b) == Sign::positive;
}

}  // namespace sectile
