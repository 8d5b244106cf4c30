#include "import/crossing.h"

#include "search/box_tree.h"
#include "selftest/rim_sweep.h"

namespace sectile {
namespace {

using Edge = RimEdge;

Sign turn(const Kernel& kernel, int axis, const Edge& edge, PointId p) {
  return kernel.turn(edge.from, edge.to, p, axis);
}

bool separates(const Kernel& kernel, int axis, const Edge& line, const Edge& edge) {
  const Sign from = turn(kernel, axis, line, edge.from);
  return from != Sign::zero && from == -turn(kernel, axis, line, edge.to);
}

bool cross(const Kernel& kernel, int axis, const Edge& a, const Edge& b) {
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return false;
  return separates(kernel, axis, a, b) && separates(kernel, axis, b, a);
}

bool is_convex(const Kernel& kernel, int axis, const std::vector<Edge>& edges) {
  const Sign first = turn(kernel, axis, edges[0], edges[1].to);
  if (first == Sign::zero) return false;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (turn(kernel, axis, edges[i], edges[i + 1 < edges.size() ? i + 1 : 0].to) != first)
      return false;
  return true;
}

bool any_pair_crosses(const Kernel& kernel, int axis, const std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 2; j < edges.size(); ++j)
      if (cross(kernel, axis, edges[i], edges[j])) return true;
  return false;
}

bool any_overlap_crosses(const Kernel& kernel, int axis, const std::vector<Edge>& edges) {
  const Geometry& g = kernel.geometry();
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& e : edges) {
    Bounds bounds;
    bounds.add(g.position(e.from));
    bounds.add(g.position(e.to));
    boxes.push_back(bounds.box());
  }
  const BoxTree tree(boxes);
  bool found = false;
  BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
    found = found || (i < j && cross(kernel, axis, edges[i], edges[j]));
  });
  return found;
}

}  // namespace

bool edges_cross(const Kernel& kernel, int axis, bool behind, std::span<const PointId> corners,
                 std::span<const std::uint32_t> loop_ends) {
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t end : loop_ends) {
    for (std::uint32_t i = begin; i < end; ++i)
      edges.push_back({corners[i], corners[i + 1 < end ? i + 1 : begin]});
    begin = end;
  }
  // Four turns to one side make one round.
  if (edges.size() == 4 && loop_ends.size() == 1 && is_convex(kernel, axis, edges)) return false;
  constexpr std::size_t few = 16;
  if (edges.size() <= few) return any_pair_crosses(kernel, axis, edges);
  // Long slanted edges have boxes that overlap by the million; a sweep tells that nothing crosses,
  // as a rule.
  if (RimSweep(kernel).winds_once(edges, axis, behind)) return false;
  return any_overlap_crosses(kernel, axis, edges);
}

}  // namespace sectile
