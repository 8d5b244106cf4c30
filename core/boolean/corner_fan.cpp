#include "boolean/corner_fan.h"

#include <algorithm>

namespace sectile {

CornerFan::CornerFan(const Kernel& kernel, const Patch& patch, std::span<const HalfEdgeId> leaving)
    : plane_(patch.brep.plane_of(leaving[0])),
      point_(patch.brep.point_of(patch.brep.from(leaving[0]))) {
  const Direction start = direction_of(kernel, patch, leaving[0]);
  const auto add = [&](HalfEdgeId h, Direction d, bool begins) {
    const int q = quarter(kernel, plane_, start, d);
    bounds_.push_back({d, h, begins, static_cast<std::uint8_t>(q)});
  };
  bounds_.reserve(2 * leaving.size());
  for (const HalfEdgeId h : leaving) {
    const HalfEdgeId before = previous_with_length(patch.brep, h);
    add(h, direction_of(kernel, patch, h), true);
    add(before, -direction_of(kernel, patch, before), false);
  }
  std::sort(bounds_.begin(), bounds_.end(), [&](const Bound& a, const Bound& b) {
    if (a.quarter != b.quarter) return a.quarter < b.quarter;
    const bool halfway = a.quarter % 2 == 0;  // there is one direction
    const Sign to_b = halfway ? Sign::zero : turn(kernel, plane_, a.direction, b.direction);
    if (to_b != Sign::zero) return to_b == Sign::positive;
    return a.begins != b.begins ? b.begins : a.h < b.h;
  });
}

template <class TurnTo>
CornerFan::Gap CornerFan::gap(int quarter, const TurnTo& turn_to) const {
  const auto count = [&](const auto& is_before) {
    const auto end = std::partition_point(bounds_.begin(), bounds_.end(), [&](const Bound& b) {
      if (b.quarter != quarter) return b.quarter < quarter;
      return is_before(quarter % 2 == 0 ? Sign::zero : turn_to(b));
    });
    return static_cast<std::size_t>(end - bounds_.begin());
  };
  return {count([](Sign to_bound) { return to_bound == Sign::negative; }),
          count([](Sign to_bound) { return to_bound != Sign::positive; })};
}

CornerFan::Gap CornerFan::gap(const Kernel& kernel, Direction d) const {
  return gap(quarter(kernel, plane_, bounds_[0].direction, d),
             [&](const Bound& b) { return turn(kernel, plane_, d, b.direction); });
}

// Of the direction to a point.
CornerFan::Gap CornerFan::gap(const Kernel& kernel, PointId p) const {
  const Direction start = bounds_[0].direction;
  const auto turn_to = [&](Direction d) { return turn_from(kernel, p, d); };
  int q = 0;
  if (const Sign to_start = turn_to(start); to_start != Sign::zero)
    q = to_start == Sign::negative ? 1 : 3;
  else if (direction_between(kernel, plane_, start.across, point_, p).sense != start.sense)
    q = 2;
  return gap(q, [&](const Bound& b) { return turn_to(b.direction); });
}

const CornerFan::Bound& CornerFan::last(const Kernel& kernel, Direction d) const {
  const std::size_t behind = gap(kernel, d).behind;
  return bounds_[(behind > 0 ? behind : size()) - 1];
}

CornerFan::Range CornerFan::along(const Kernel& kernel, Direction d) const {
  const Gap at = gap(kernel, d);
  return {at.before, at.behind - at.before};
}

CornerFan::Range CornerFan::towards(const Kernel& kernel, PointId from, PointId to) const {
  const int axis = kernel.main_axis(plane_);
  const Sign sign = kernel.turn(point_, from, to, axis) * kernel.normal(plane_, axis);
  Gap first = gap(kernel, from), last = gap(kernel, to);
  if (sign == Sign::zero) {
    const bool one_way = first.before == last.before && first.behind == last.behind;
    if (!one_way || first.before == first.behind) return {0, size()};
  }
  if (sign == Sign::negative) {
    std::swap(first, last);
    std::swap(from, to);
  }
  bool passes_start = last.behind < first.before;
  if (last.behind == first.before) {  // none of them or all
    const Direction next = (*this)[first.before].direction;
    passes_start =
        first.before < first.behind || (turn_from(kernel, from, next) == Sign::positive &&
                                        turn_from(kernel, to, next) != Sign::positive);
  }
  return {first.before, last.behind + (passes_start ? size() : 0) - first.before};
}

}  // namespace sectile
