#include "storage/shared_points.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace sectile {
namespace {

// With the first of those before it that is at the same point.
void share_point(Brep& brep, const Kernel& kernel, std::span<const VertexId> before,
                 PointId& point) {
  for (const VertexId v : before)
    if (kernel.same_point(brep.point[v], point)) {
      point = brep.point[v];
      return;
    }
}

}  // namespace

void share_points(Brep& brep, const Kernel& kernel) {
  std::vector<VertexId> order(brep.vertices().begin(), brep.vertices().end());
  const auto position = [&](VertexId v) -> const Vec3& {
    return kernel.geometry().position(brep.point_of(v));
  };
  std::sort(order.begin(), order.end(), [&](VertexId i, VertexId j) {
    const Vec3 &p = position(i), &q = position(j);
    return std::tie(p.x, p.y, p.z, i) < std::tie(q.x, q.y, q.z, j);
  });
  for (std::size_t from = 0, to; from < order.size(); from = to) {
    const Vec3 place = position(order[from]);
    for (to = from + 1; to < order.size() && position(order[to]) == place; ++to)
      share_point(brep, kernel, std::span(order).subspan(from, to - from), brep.point[order[to]]);
  }
}

}  // namespace sectile
