// Sectors of wedges and gaps around an edge, in whole numbers, where all is known by cross
// products.
#include "rounding/edge_sectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

#include "cases.h"
#include "unit/rounding/half_planes.h"

namespace sectile {
namespace {

using test::cross;
using test::Direction;

bool is_upper(const Direction& d) {
  return d.y > 0 || (d.y == 0 && d.x > 0);
}
bool comes_before(const Direction& a, const Direction& b) {
  return is_upper(a) != is_upper(b) ? is_upper(a) : cross(a, b) > 0;
}
// Counter-clockwise between two others.
bool is_between(const Direction& d, const Direction& from, const Direction& to) {
  return comes_before(from, to) ? comes_before(from, d) && comes_before(d, to)
                                : comes_before(from, d) || comes_before(d, to);
}
bool is_less_than_half(const Direction& from, const Direction& to) {
  return cross(from, to) > 0;
}

constexpr int size = 12;

std::vector<Direction> all_directions() {
  std::vector<Direction> all;
  for (int x = -size; x <= size; ++x)
    for (int y = -size; y <= size; ++y)
      if (std::gcd(x, y) == 1) all.push_back({x, y});
  std::sort(all.begin(), all.end(), comes_before);
  return all;
}

// Wedges around the z axis, whose edge runs up, or down, between some of all directions.
struct Around {
  std::vector<Direction> right, left;  // of the wedges, counter-clockwise
  Geometry geometry;
  Kernel kernel{geometry};
  std::vector<EdgeSectors::Wedge> wedges;
  PointId low, high;

  Around(std::mt19937& random, std::size_t n) {
    std::vector<Direction> some = all_directions();
    std::shuffle(some.begin(), some.end(), random);
    some.resize(2 * n);
    std::sort(some.begin(), some.end(), comes_before);
    std::rotate(some.begin(), some.begin() + random() % 2, some.end());
    for (std::size_t i = 0; i < some.size(); ++i) (i % 2 == 0 ? right : left).push_back(some[i]);
    low = geometry.add_point({0, 0, -3});
    high = geometry.add_point({0, 0, 40});
    for (std::uint32_t i = 0; i < n; ++i) {
      const PointId of_left = point(left[i], random), of_right = point(right[i], random);
      const PlaneId above = geometry.add_plane(PlaneDefinition::through(low, high, of_left)),
                    below = geometry.add_plane(PlaneDefinition::through(high, low, of_right));
      wedges.push_back({{2 * i, above, of_left}, {2 * i + 1, below, of_right}});
    }
    kernel.refresh();
  }

  PointId point(const Direction& d, std::mt19937& random) {
    return geometry.add_point({1.0 * d.x, 1.0 * d.y, static_cast<double>(random() % 50)});
  }
  EdgeSectors sectors(bool upwards) {
    if (upwards) return {low, high, wedges, geometry, kernel};
    std::vector<EdgeSectors::Wedge> turned;
    for (const auto& [left_side, right_side] : wedges) turned.push_back({right_side, left_side});
    return {high, low, turned, geometry, kernel};
  }
  bool is_in(const Direction& d, const EdgeSectors::Sector& sector, Sign side) {
    const PointId p = geometry.add_point({1.0 * d.x, 1.0 * d.y, 0});
    kernel.refresh();
    return !sector.planes.empty() &&
           std::all_of(sector.planes.begin(), sector.planes.end(),
                       [&](PlaneId plane) { return kernel.side(p, plane) == side; });
  }
};

void expect_wedges_and_gaps_in_their_sectors(Around& around, const EdgeSectors& sectors) {
  const std::size_t n = around.wedges.size();
  ASSERT_EQ(sectors.order().size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t wedge = sectors.order()[i], next = sectors.order()[(i + 1) % n];
    const Direction right = around.right[wedge], left = around.left[wedge],
                    next_right = around.right[next];
    EXPECT_EQ(!sectors.of_wedge(i).planes.empty(), is_less_than_half(right, left));
    EXPECT_EQ(!sectors.of_gap(i).planes.empty(), is_less_than_half(left, next_right));
    for (const Direction& d : all_directions()) {
      if (is_between(d, right, left) && is_less_than_half(right, left)) {
        EXPECT_TRUE(around.is_in(d, sectors.of_wedge(i), Sign::negative));
      }
      if (is_between(d, left, next_right) && is_less_than_half(left, next_right)) {
        EXPECT_TRUE(around.is_in(d, sectors.of_gap(i), Sign::negative));
      }
    }
  }
}

void expect_nothing_in_two_that_are_apart(Around& around, const EdgeSectors& sectors) {
  const std::size_t n = around.wedges.size();
  for (const Direction& d : all_directions()) {
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < n; ++i) {
      if (around.is_in(d, sectors.of_wedge(i), Sign::negative)) in.push_back(i);
      if (around.is_in(d, sectors.of_gap(i), Sign::negative)) in.push_back(n + i);
    }
    for (const std::size_t a : in)
      for (const std::size_t b : in) EXPECT_FALSE(EdgeSectors::are_apart(n, a, b));
  }
}

TEST(EdgeSectors, HoldTheirWedgesAndGapsAndAreApart) {
  for (int seed = 0; seed < cases(20); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    Around around(random, 2 + static_cast<std::size_t>(seed) % 12);
    for (const bool upwards : {true, false}) {
      const EdgeSectors sectors = around.sectors(upwards);
      expect_wedges_and_gaps_in_their_sectors(around, sectors);
      expect_nothing_in_two_that_are_apart(around, sectors);
    }
  }
}

// What is bent a little beyond a wall is in its sector all the same.
TEST(EdgeSectors, AWedgeIsWellWithinItsSector) {
  std::mt19937 random(1);
  Around around(random, 20);
  const EdgeSectors sectors = around.sectors(true);
  for (std::size_t i = 0; i < 20; ++i) {
    const std::uint32_t wedge = sectors.order()[i];
    if (sectors.of_wedge(i).planes.empty()) continue;
    for (const Direction& d : {around.right[wedge], around.left[wedge]})
      EXPECT_TRUE(around.is_in(d, sectors.of_wedge(i), Sign::negative));
  }
}

TEST(EdgeSectors, AllButNeighboursAreApart) {
  for (const std::size_t n : {2u, 3u, 7u})
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        EXPECT_EQ(EdgeSectors::are_apart(n, a, b), a != b);
        EXPECT_EQ(EdgeSectors::are_apart(n, n + a, n + b), a != b);
        EXPECT_EQ(EdgeSectors::are_apart(n, a, n + b), b != a && (b + 1) % n != a);
      }
}

TEST(EdgeSectors, ThereAreNoneWhereWedgesOverlap) {
  std::mt19937 random(1);
  Around around(random, 5);
  around.wedges.push_back(around.wedges.front());
  EXPECT_TRUE(around.sectors(true).order().empty());
}

}  // namespace
}  // namespace sectile
