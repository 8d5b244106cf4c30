// The box around an edge.
#pragma once

#include "geometry/geometry.h"
#include "search/box.h"

namespace sectile {

inline Box edge_box(const Geometry& geometry, PointId from, PointId to) {
  Bounds bounds;
  bounds.add(geometry.position(from));
  bounds.add(geometry.position(to));
  return bounds.box();
}

}  // namespace sectile
