#include "selftest/triangle_tree.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

template <class Body>
void for_range(std::size_t count, const Body& body) {
  parallel::loop(parallel::Range<std::size_t>(0, count, 2048), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

Box triangle_box(const TriangleSurface& surface, const Geometry& geometry, std::uint32_t t) {
  Bounds bounds;
  for (const PointId p : surface.corners[t]) bounds.add(geometry.position(p));
  return bounds.box();
}

void sort_along_curve(std::vector<std::uint32_t>& triangles, const TriangleSurface& surface,
                      const Geometry& geometry) {
  std::vector<Box> boxes(triangles.size());
  for_range(boxes.size(),
            [&](std::size_t i) { boxes[i] = triangle_box(surface, geometry, triangles[i]); });
  const std::vector<std::uint32_t> order = order_along_curve(boxes);
  for_range(order.size(),
            [&, given = triangles](std::size_t i) { triangles[i] = given[order[i]]; });
}

}  // namespace

TriangleTree::TriangleTree(const TriangleSurface& surface, const Geometry& geometry,
                           std::vector<std::uint32_t> triangles) {
  order_ = std::move(triangles);
  if (!surface.along_curve) sort_along_curve(order_, surface, geometry);
  boxes_.emplace_back((order_.size() + 7) / 8);
  for_range(boxes_[0].size(), [&](std::size_t node) {
    for (unsigned i = 0; i < children(0, node); ++i)
      boxes_[0][node].set(i, triangle_box(surface, geometry, order_[8 * node + i]));
  });
  while (boxes_.back().size() > 1) {
    const std::size_t level = boxes_.size();
    boxes_.emplace_back((boxes_.back().size() + 7) / 8);
    for_range(boxes_[level].size(), [&](std::size_t node) {
      for (unsigned i = 0; i < children(level, node); ++i)
        boxes_[level][node].set(i, boxes_[level - 1][8 * node + i].all());
    });
  }
}

}  // namespace sectile
