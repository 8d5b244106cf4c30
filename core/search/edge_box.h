// The box around an edge.
#pragma once

#include "geometry/geometry.h"
#include "search/box.h"

namespace sectile {

inline Box edge_box(const Geometry& geometry, PointId from, PointId to) {
  return box_around(geometry.position(from), geometry.position(to));
}

}  // namespace sectile
