#pragma once

#include "topology/brep.h"

namespace sectile {

/// Has a face three corners and no hole?
inline bool is_triangle(const Brep& brep, FaceId f) {
  const LoopId outer = brep.outer_loop[f];
  const HalfEdgeId h = brep.loop_half_edge[outer];
  return !brep.next_loop[outer].valid() && brep.next_of(brep.next_of(h)) == brep.prev_of(h);
}

}  // namespace sectile
