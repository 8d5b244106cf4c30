#include "search/piece_tree.h"

namespace sectile {
namespace {

std::vector<Box> boxes_of(std::span<const PieceTree::Edge> edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const PieceTree::Edge& e : edges) boxes.push_back(box_around(e.from, e.to));
  return boxes;
}

// Do boxes cover each other many times over, by half their surfaces, so that oriented ones are
// worth their while?
bool are_slanted(std::span<const Box> boxes) {
  constexpr double many_times = 4;
  constexpr std::size_t few = 32;
  if (boxes.size() < few) return false;
  const auto surface = [](const Box& b) {
    const double x = double(b.high[0]) - double(b.low[0]), y = double(b.high[1]) - double(b.low[1]),
                 z = double(b.high[2]) - double(b.low[2]);
    return x * y + y * z + z * x;
  };
  Box all;
  double sum = 0;
  for (const Box& b : boxes) {
    all.add(b);
    sum += surface(b);
  }
  return sum > many_times * surface(all);
}

}  // namespace

PieceTree::PieceTree(std::span<const Edge> edges, bool along_curve) {
  const std::vector<Box> boxes = boxes_of(edges);
  tree_ = BoxTree(boxes, {}, along_curve);
  if (are_slanted(boxes))
    oriented_.emplace(tree_, [&](std::uint32_t e, const auto& add) {
      add(edges[e].from);
      add(edges[e].to);
    });
}

PieceTree::PieceTree(std::span<const Vec3> hull) {
  Bounds bounds;
  for (const Vec3& p : hull) bounds.add(p);
  tree_ = BoxTree({bounds.box()});
  oriented_.emplace(tree_, [&](std::uint32_t, const auto& add) {
    for (const Vec3& p : hull) add(p);
  });
}

}  // namespace sectile
