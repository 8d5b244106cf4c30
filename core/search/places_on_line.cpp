#include "search/places_on_line.h"

#include <algorithm>

namespace sectile {
namespace {

int axis_of_line(const Kernel& kernel, std::span<const PointId> points) {
  for (const PointId p : points)
    for (int axis = 0; axis < 3; ++axis)
      if (kernel.compare(points[0], p, axis) != Sign::zero) return axis;
  return 0;
}

}  // namespace

PlacesOnLine::PlacesOnLine(const Kernel& kernel, std::span<const PointId> points)
    : kernel_(kernel), axis_(axis_of_line(kernel, points)), places_(points.begin(), points.end()) {
  std::ranges::sort(places_, [&](PointId p, PointId q) {
    const Sign up = kernel.compare(p, q, axis_);
    return up != Sign::zero ? up == Sign::positive : p < q;
  });
  const auto again = std::unique(places_.begin(), places_.end(), [&](PointId p, PointId q) {
    return kernel.compare(p, q, axis_) == Sign::zero;
  });
  places_.erase(again, places_.end());
}

std::size_t PlacesOnLine::of(PointId p) const {
  const auto at = std::ranges::partition_point(
      places_, [&](PointId q) { return kernel_.compare(q, p, axis_) == Sign::positive; });
  return static_cast<std::size_t>(at - places_.begin());
}

}  // namespace sectile
