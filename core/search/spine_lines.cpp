#include "search/spine_lines.h"

#include "numbers/disjoint_sets.h"
#include "search/box_tree.h"

namespace sectile {
namespace {

bool are_on_one_line(const Kernel& kernel, PointId p, PointId q, PointId r) {
  for (int axis = 0; axis < 3; ++axis)
    if (kernel.turn(p, q, r, axis) != Sign::zero) return false;
  return true;
}

}  // namespace

SpineLines::SpineLines(const Kernel& kernel, std::span<const PointId> points,
                       std::span<const Hubs::Spine> spines) {
  if (spines.empty()) return;
  const auto at = [&](std::uint32_t point) { return kernel.geometry().position(points[point]); };
  std::vector<Box> boxes;
  for (const Hubs::Spine& s : spines) {
    boxes.push_back(box_around(at(s.from), at(s.to)));
    lines_.emplace_back(at(s.from), at(s.to));
  }
  const BoxTree tree(boxes);
  const auto is_on = [&](std::uint32_t point, std::uint32_t spine) {
    const auto [from, to] = spines[spine];
    return point == from || point == to ||
           are_on_one_line(kernel, points[from], points[to], points[point]);
  };
  DisjointSets lines(spines.size());
  BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
    if (i < j && lines.first(i) != lines.first(j) && is_on(spines[j].from, i) &&
        is_on(spines[j].to, i))
      lines.unite(i, j);
  });
  std::vector<Box> places;
  for (std::uint32_t i = 0; i < points.size(); ++i) places.push_back(box_around(at(i), at(i)));
  of_point_.assign(points.size(), none);
  BoxTree::overlaps(BoxTree(places), tree, [&](std::uint32_t i, std::uint32_t j) {
    if (lines.first(j) < of_point_[i] && is_on(i, j)) of_point_[i] = lines.first(j);
  });
}

}  // namespace sectile
