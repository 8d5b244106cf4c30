// Faces with integer coordinates for the tests of triangulation, and what a triangulation must be.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/triangulation.h"
#include "numbers/sign.h"

namespace sectile::test {

struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

inline std::int64_t area2(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
inline Sign sign_of_integer(std::int64_t value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

struct GridPredicates {
  const std::vector<GridPoint>& points;
  Sign compare(std::uint32_t i, std::uint32_t j) const {
    const GridPoint &a = points[i], &b = points[j];
    return sign_of_integer(a.x != b.x ? b.x - a.x : b.y - a.y);
  }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return sign_of_integer(area2(points[i], points[j], points[k]));
  }
  std::array<double, 2> seen(std::uint32_t i) const {
    return {static_cast<double>(points[i].x), static_cast<double>(points[i].y)};
  }
};

using Loop = std::vector<GridPoint>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A face: its loops, and the same flat.
struct Region {
  std::vector<GridPoint> points;
  std::vector<std::uint32_t> loop_ends;

  Region() = default;
  explicit Region(const std::vector<Loop>& loops) {
    for (const Loop& loop : loops) add(loop);
  }
  void add(const Loop& loop) {
    points.insert(points.end(), loop.begin(), loop.end());
    loop_ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
  GridPredicates predicates() const { return {points}; }
  std::uint32_t loop_begin(std::size_t loop) const { return loop == 0 ? 0 : loop_ends[loop - 1]; }
};

}  // namespace sectile::test
