#include "search/spine_lines.h"

#include "search/piece_tree.h"

namespace sectile {

SpineLines::SpineLines(const Kernel& kernel, std::span<const PointId> points,
                       std::span<const PointPair> edges) {
  if (edges.empty()) return;
  const auto at = [&](std::uint32_t point) { return kernel.geometry().position(points[point]); };
  std::vector<PieceTree::Edge> pieces, places;
  for (const EdgesOfLine& line : edges_by_line(kernel, points, edges)) {
    const auto [from, to] = line.extent;
    extents_.push_back(line.extent);
    pieces.push_back({at(from), at(to)});
    lines_.emplace_back(at(from), at(to));
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) places.push_back({at(i), at(i)});
  const auto is_on = [&](std::uint32_t point, std::uint32_t line) {
    const auto [from, to] = extents_[line];
    return point == from || point == to ||
           are_on_one_line(kernel, points[from], points[to], points[point]);
  };
  PieceTree::overlaps(PieceTree(places), PieceTree(pieces), [&](std::uint32_t i, std::uint32_t j) {
    if (is_on(i, j)) on_.push_back({i, j});
  });
  std::ranges::sort(on_);
}

}  // namespace sectile
