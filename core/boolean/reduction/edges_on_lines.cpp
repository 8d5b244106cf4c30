#include "boolean/reduction/edges_on_lines.h"

#include <algorithm>
#include <vector>

#include "search/spine_lines.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = SpineLines::none;

// On which both ends of an edge are, if they are on one.
std::uint32_t line_of(const SpineLines& lines, const PointPair& edge) {
  for (const SpineLines::On& p : lines.of_point(edge.from))
    for (const SpineLines::On& q : lines.of_point(edge.to))
      if (p.line == q.line) return p.line;
  return none;
}

}  // namespace

void unite_on_lines(const Workspace& w, std::span<const SegmentRecord> records,
                    DisjointSets& edges) {
  const Brep& brep = w.patch[Operand::a].brep;
  std::vector<EdgeId> ids;
  for (const SegmentRecord& r : records) ids.push_back(r.on[Operand::a].edge());
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<PointId> points;
  std::vector<PointPair> pairs;
  for (const EdgeId e : ids) {
    const HalfEdgeId h = Brep::half_edge(e);
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {brep.point_of(brep.from(h)), brep.point_of(brep.to(h))});
    pairs.push_back({first, first + 1});
  }
  const SpineLines lines(w.tests(), points, crowded_lines(w.tests(), points, pairs, 1));
  std::vector<std::uint32_t> first(lines.count(), none);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t line = line_of(lines, pairs[i]);
    if (line == none) continue;
    if (first[line] == none) first[line] = ids[i].value();
    edges.unite(first[line], ids[i].value());
  }
}

}  // namespace sectile
