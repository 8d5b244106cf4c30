// Points on one line, in their order along it.
#pragma once

#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

class PlacesOnLine {
 public:
  PlacesOnLine(const Kernel& kernel, std::span<const PointId> points);

  std::size_t count() const { return places_.size(); }
  /// The number of the place of a point on the line: equal points are in one place.
  std::size_t of(PointId p) const;
  /// One of the points in a place, the first by number.
  PointId at(std::size_t place) const { return places_[place]; }
  /// One on which the line has an extent, in whose direction the places are numbered.
  int axis() const { return axis_; }

 private:
  const Kernel& kernel_;
  int axis_;
  std::vector<PointId> places_;  // one point for each
};

}  // namespace sectile
