#include "selftest/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel/parallel.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

template <class Body>
void for_range(std::size_t count, const Body& body) {
  parallel::loop(tbb::blocked_range<std::size_t>(0, count, 2048), [&](const auto& range) {
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
  Box all;
  for (const Box& b : boxes) all.add(b);
  const std::vector<std::uint32_t> order =
      numbers_of(keys_along_curve(boxes.size(), all, [&](std::size_t i) { return boxes[i]; }));
  for_range(order.size(),
            [&, given = triangles](std::size_t i) { triangles[i] = given[order[i]]; });
}

}  // namespace

// No comparison with them holds: boxes without end overlap them no more than others do.
EightBoxes::EightBoxes() {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (unsigned i = 0; i < 8; ++i) set(i, {{none, none, none}, {none, none, none}});
}

void EightBoxes::set(unsigned i, const Box& box) {
  for (int k = 0; k < 3; ++k) {
    low[k][i] = box.low[k];
    high[k][i] = box.high[k];
  }
}

Box EightBoxes::get(unsigned i) const {
  return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
}

Box EightBoxes::all() const {
  Box box;
  for (unsigned i = 0; i < 8; ++i) box.add(get(i));
  return box;
}

unsigned EightBoxes::overlapping(const Box& box) const {
  unsigned apart[8] = {};
  for (int k = 0; k < 3; ++k)
    for (unsigned i = 0; i < 8; ++i)
      apart[i] |= static_cast<unsigned>(!(low[k][i] <= box.high[k])) |
                  static_cast<unsigned>(!(box.low[k] <= high[k][i]));
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= (apart[i] ^ 1u) << i;
  return bits;
}

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
