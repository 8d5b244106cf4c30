#include "boolean/reduction/points_on_lines.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace sectile {
namespace {

struct Marked {
  Operand operand;
  VertexId v;
};

class PointSharing {
 public:
  explicit PointSharing(Workspace& w) : w_(w) {}

  // Of those that are at no place of the contacts.
  void run(std::vector<Marked> vertices) {
    std::ranges::sort(vertices, [&](const Marked& i, const Marked& j) {
      const Vec3 &p = position(i), &q = position(j);
      return std::tie(p.x, p.y, p.z, i.operand, i.v) < std::tie(q.x, q.y, q.z, j.operand, j.v);
    });
    for (std::size_t from = 0, to; from < vertices.size(); from = to) {
      std::vector<PointId> points;  // at one rounded place: one, as a rule
      for (to = from; to < vertices.size() && position(vertices[to]) == position(vertices[from]);)
        share(vertices[to++], points);
    }
  }

 private:
  PointId& point(const Marked& i) { return w_.patch[i.operand].brep.point[i.v]; }
  const Vec3& position(const Marked& i) { return w_.geometry.position(point(i)); }

  void share(const Marked& i, std::vector<PointId>& points) {
    const auto known =
        std::ranges::find_if(points, [&](PointId p) { return w_.tests().same_point(p, point(i)); });
    if (known == points.end())
      points.push_back(point(i));
    else
      point(i) = *known;
  }

  Workspace& w_;
};

}  // namespace

void share_points_on_lines(Workspace& w, const Contacts& found, const PlacesByPoint& places) {
  std::vector<Marked> others;
  for (const Operand s : both_operands) {
    Patch& patch = w.patch[s];
    for (const VertexId v : patch.on_crowded_line.ids()) {
      if (patch.on_crowded_line[v] == 0) continue;
      if (const auto place = places.find(patch.brep.point_of(v)))
        patch.brep.point[v] = found.point(*place);
      else
        others.push_back({s, v});
    }
  }
  PointSharing(w).run(std::move(others));
}

}  // namespace sectile
