// Oriented boxes for the nodes of a box index: where things are long, thin and slanted,
// axis-parallel boxes say little.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/oriented_box.h"

namespace sectile {

/// For an index of items that came along a curve.
class OrientedIndex {
 public:
  OrientedIndex() = default;
  /// for_each_point(item, add) calls add(point) for points, at least one, around whose convex hull
  /// an item is, but for `slack` in each coordinate.
  template <class ForEachPoint>
  OrientedIndex(std::size_t items, double slack, const ForEachPoint& for_each_point) {
    std::vector<Vec3> points;
    for (std::size_t width = 1; width == 1 || width < 4 * items; width *= 4) {
      std::vector<OrientedBox>& level = levels_.emplace_back();
      for (std::size_t from = 0; from < items; from += width) {
        points.clear();
        for (std::size_t i = from; i < std::min(from + width, items); ++i)
          for_each_point(static_cast<std::uint32_t>(i),
                         [&](const Vec3& p) { points.push_back(p); });
        level.push_back(OrientedBox(points));
        level.back().slack += slack;
      }
    }
  }
  /// Around all items from 4^level · index on, up to 4^level of them.
  const OrientedBox& at(std::uint64_t level, std::uint32_t index) const {
    return levels_[level][index];
  }

 private:
  std::vector<std::vector<OrientedBox>> levels_;
};

}  // namespace sectile
