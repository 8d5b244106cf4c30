// Boxes around triangles, eight by eight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "search/four_boxes.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Triangles in the order of a curve. Node i of level 0 has the triangles 8 i to 8 i + 7 of that
/// order, and node i of level l + 1 the nodes 8 i to 8 i + 7 of level l.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// Of some of the triangles.
  TriangleTree(const TriangleSurface& surface, const Geometry& geometry,
               std::vector<std::uint32_t> triangles);

  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t levels() const { return boxes_.size(); }
  std::size_t nodes(std::size_t level) const { return boxes_[level].size(); }
  const EightBoxes& boxes(std::size_t level, std::size_t node) const { return boxes_[level][node]; }
  /// How many triangles or nodes of the level below a node has.
  unsigned children(std::size_t level, std::size_t node) const {
    const std::size_t below = level > 0 ? boxes_[level - 1].size() : order_.size();
    return static_cast<unsigned>(std::min<std::size_t>(8, below - 8 * node));
  }
  /// The triangles of a node: a range of the order.
  std::pair<std::uint32_t, std::uint32_t> range(std::size_t level, std::size_t node) const {
    const std::size_t shift = 3 * (level + 1);
    return {static_cast<std::uint32_t>(node << shift),
            static_cast<std::uint32_t>(std::min(order_.size(), (node + 1) << shift))};
  }

 private:
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<EightBoxes>> boxes_;  // per level
};

}  // namespace sectile
