// What a triangulation must be, checked without knowing how it was made.
#pragma once

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <utility>

#include "unit/geometry/grid_predicates.h"

namespace sectile::test {

using PlaceEdge = std::pair<GridPoint, GridPoint>;

inline std::int64_t loop_area2(const Region& region, std::size_t loop) {
  const GridPoint origin;
  std::int64_t sum = 0;
  const std::uint32_t begin = region.loop_begin(loop), end = region.loop_ends[loop];
  for (std::uint32_t i = begin; i < end; ++i) {
    sum += area2(origin, region.points[i], region.points[i + 1 == end ? begin : i + 1]);
  }
  return sum;
}

/// The edges of all loops. If another edge ends within one, on its left, it is divided there.
inline std::vector<PlaceEdge> expected_boundary(const Region& region, bool touching_edges) {
  std::vector<PlaceEdge> edges, pieces;
  for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop) {
    const std::uint32_t begin = region.loop_begin(loop), end = region.loop_ends[loop];
    for (std::uint32_t i = begin; i < end; ++i) {
      edges.emplace_back(region.points[i], region.points[i + 1 == end ? begin : i + 1]);
    }
  }
  if (!touching_edges) return edges;
  for (const auto& [a, b] : edges) {
    std::vector<GridPoint> stops{a, b};
    const auto consider = [&stops, a = a, b = b](const GridPoint& p, const GridPoint& other) {
      if (area2(a, b, p) == 0 && area2(a, b, other) > 0 && std::min(a, b) < p &&
          p < std::max(a, b)) {
        stops.push_back(p);
      }
    };
    for (const auto& [c, d] : edges) {
      consider(c, d);
      consider(d, c);
    }
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    if (b < a) std::reverse(stops.begin(), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) pieces.emplace_back(stops[i], stops[i + 1]);
  }
  return pieces;
}

/// Triangles are counter-clockwise and their sides, taken together, are the boundary: so they cover
/// the region exactly once, and side by side without T-junctions.
inline void expect_covers(const Region& region, const Triangles& triangles,
                          bool touching_edges = true) {
  std::map<PlaceEdge, int> sides, boundary;
  std::int64_t area = 0, expected_area = 0;
  for (const auto& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      ASSERT_LT(triangle[i], region.points.size());
      ++sides[{region.points[triangle[i]], region.points[triangle[(i + 1) % 3]]}];
    }
    const std::int64_t part =
        area2(region.points[triangle[0]], region.points[triangle[1]], region.points[triangle[2]]);
    ASSERT_GT(part, 0);
    area += part;
  }
  for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop) {
    expected_area += loop_area2(region, loop);
  }
  EXPECT_EQ(area, expected_area);
  for (const PlaceEdge& edge : expected_boundary(region, touching_edges)) ++boundary[edge];
  for (const auto& [edge, count] : boundary) {
    ASSERT_EQ(count, 1);
    const auto side = sides.find(edge);
    ASSERT_TRUE(side != sides.end()) << "boundary edge without a triangle";
  }
  for (const auto& [edge, count] : sides) {
    ASSERT_EQ(count, 1) << "two triangles at one side of an edge";
    if (boundary.count(edge)) continue;
    ASSERT_TRUE(sides.count({edge.second, edge.first})) << "inner edge with one triangle";
    ASSERT_FALSE(boundary.count({edge.second, edge.first}));
  }
}

/// Every undivided edge of a loop belongs to a triangle by its corners' own numbers.
inline void expect_own_corners(const Region& region, const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::map<PlaceEdge, int> undivided;
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  for (const PlaceEdge& edge : expected_boundary(region, true)) ++undivided[edge];
  for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop) {
    const std::uint32_t begin = region.loop_begin(loop), end = region.loop_ends[loop];
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t next = i + 1 == end ? begin : i + 1;
      if (!undivided.count({region.points[i], region.points[next]})) continue;
      const auto side = sides.find({i, next});
      ASSERT_TRUE(side != sides.end()) << "edge " << i;
      ASSERT_EQ(side->second, 1);
    }
  }
}

inline Triangles triangles_of(const Region& region) {
  Triangles triangles;
  triangulate(region.predicates(), region.loop_ends, triangles);
  return triangles;
}

/// By the sweep, however few the corners are.
inline Triangles swept_triangles_of(const Region& region) {
  Triangles triangles;
  const GridPredicates predicates = region.predicates();
  RegionSweep(predicates, region.loop_ends, triangles).run();
  return triangles;
}

/// With edges flipped, however few the corners are.
inline Triangles shaped_triangles_of(const Region& region) {
  Triangles triangles = swept_triangles_of(region);
  const GridPredicates predicates = region.predicates();
  EdgeFlips<GridPredicates>(predicates, region.loop_ends, triangles, 0).run();
  return triangles;
}

/// No inner edge that is not a slit could be flipped with both of the triangles' circles emptied by
/// that.
inline void expect_well_shaped(const Region& region, const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> apex;
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) apex[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
  const auto at = [&](std::uint32_t corner) { return region.points[corner]; };
  std::map<std::uint32_t, std::uint32_t> after;  // on the loops
  for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop)
    for (std::uint32_t i = region.loop_begin(loop), end = region.loop_ends[loop]; i < end; ++i)
      after[i] = i + 1 == end ? region.loop_begin(loop) : i + 1;
  for (const auto& [edge, p] : apex) {
    const auto [a, b] = edge;
    const auto other = apex.find({b, a});
    if (other == apex.end() || after[a] == b || after[b] == a) continue;
    const std::uint32_t q = other->second;
    if (area2(at(p), at(a), at(q)) <= 0 || area2(at(q), at(b), at(p)) <= 0) continue;
    // Is q strictly within the circle through a, b and p?
    using Wide = boost::multiprecision::int128_t;
    const auto row = [&](std::uint32_t corner) {
      const Wide x = at(corner).x - at(q).x, y = at(corner).y - at(q).y;
      return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto u = row(a), v = row(b), w = row(p);
    const Wide within = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                        u[2] * (v[0] * w[1] - v[1] * w[0]);
    ASSERT_LE(within, 0) << "edge " << a << ' ' << b;
  }
}

}  // namespace sectile::test
