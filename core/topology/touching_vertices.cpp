#include "topology/touching_vertices.h"

#include <algorithm>
#include <cstdint>

#include "parallel/parallel.h"

namespace sectile {
namespace {

// Looks at vertices first … last - 1.
void mark_ends_of_several_edges(const Brep& brep, std::size_t first, std::size_t last,
                                std::vector<std::uint8_t>& marked) {
  std::vector<PointId> ends;
  for (std::size_t v = first; v < last; ++v) {
    ends.clear();
    for_each_around(brep, brep.vertex_half_edge[VertexId(v)],
                    [&](HalfEdgeId h) { ends.push_back(brep.point_of(brep.to(h))); });
    std::sort(ends.begin(), ends.end());
    marked[v] = std::adjacent_find(ends.begin(), ends.end()) != ends.end();
  }
}

void mark_at_one_place(const Brep& brep, std::vector<std::uint8_t>& marked) {
  std::uint32_t points = 0;
  for (const PointId p : brep.point) points = std::max(points, p.value() + 1);
  std::vector<std::uint8_t> seen(points, 0), several(points, 0);
  for (const PointId p : brep.point) {
    several[p.value()] = seen[p.value()];
    seen[p.value()] = 1;
  }
  for (const VertexId v : brep.vertices())
    if (several[brep.point_of(v).value()] != 0) marked[v.value()] = 1;
}

}  // namespace

std::vector<VertexId> touching_vertices(const Brep& brep) {
  std::vector<std::uint8_t> marked(brep.vertex_count(), 0);
  parallel::loop(parallel::Range<std::size_t>(0, marked.size(), 4096), [&](const auto& range) {
    mark_ends_of_several_edges(brep, range.begin(), range.end(), marked);
  });
  mark_at_one_place(brep, marked);
  std::vector<VertexId> touching;
  for (const VertexId v : brep.vertices())
    if (marked[v.value()] != 0) touching.push_back(v);
  return touching;
}

}  // namespace sectile
