#include "search/piece_tree.h"

namespace sectile {
namespace {

std::vector<Box> boxes_of(std::span<const PieceTree::Edge> edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const PieceTree::Edge& e : edges) boxes.push_back(box_around(e.from, e.to));
  return boxes;
}

}  // namespace

PieceTree::PieceTree(std::span<const Edge> edges, bool along_curve) {
  build(edges, {}, along_curve);
}

PieceTree::PieceTree(std::span<const Edge> edges, const std::vector<std::uint32_t>& group) {
  build(edges, group, false);
}

void PieceTree::build(std::span<const Edge> edges, const std::vector<std::uint32_t>& group,
                      bool along_curve) {
  const std::vector<Box> boxes = boxes_of(edges);
  tree_ = BoxTree(boxes, group, along_curve);
  if (are_mostly_empty(boxes))
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
