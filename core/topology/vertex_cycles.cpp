#include "topology/vertex_cycles.h"

namespace sectile {

void make_vertices(Brep& brep, const std::vector<PointId>& start) {
  for (const HalfEdgeId first : brep.half_edges()) {
    if (brep.origin[first].valid()) continue;
    const VertexId v(brep.vertex_count());
    brep.point.add(start[first.value()]);
    brep.vertex_half_edge.add(first);
    for_each_around(brep, first, [&](HalfEdgeId h) { brep.origin[h] = v; });
  }
}

}  // namespace sectile
