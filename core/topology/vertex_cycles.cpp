#include "topology/vertex_cycles.h"

namespace sectile {

void make_vertices(Brep& brep, const std::vector<PointId>& start) {
  for (std::size_t i = 0; i < brep.half_edge_count(); ++i) {
    if (brep.origin[i].valid()) continue;
    const HalfEdgeId first{i};
    const VertexId v(brep.vertex_count());
    brep.point.push_back(start[i]);
    brep.vertex_half_edge.push_back(first);
    for_each_around(brep, first, [&](HalfEdgeId h) { brep.origin[h.value()] = v; });
  }
}

}  // namespace sectile
