// Loops as triangles, some of which count as negative.
#pragma once

#include "topology/brep.h"

namespace sectile {

/// Calls visit(a, b, c) for the triangles of a fan of each loop, around the loop's first corner.
/// Those outside the face and those of holes count as negative.
template <class Visit>
void for_each_fan(const Brep& brep, FaceId f, const Visit& visit) {
  const auto at = [&](HalfEdgeId h) { return brep.point_of(brep.from(h)); };
  for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l]) {
    const HalfEdgeId first = brep.loop_half_edge[l];
    if (!first.valid()) continue;  // a lone vertex
    for (HalfEdgeId h = brep.next_of(first), next; (next = brep.next_of(h)) != first; h = next)
      visit(at(first), at(h), at(next));
  }
}

}  // namespace sectile
