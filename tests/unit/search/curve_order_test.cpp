// Neighbours along a curve that fills space, and groups of them.
#include "search/curve_order.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "search/curve_groups.h"

namespace sectile {
namespace {

TEST(HilbertCurve, GoesThroughEachCellOnceAndToANeighbourEachTime) {
  constexpr std::uint32_t side = 32;
  std::vector<std::array<int, 3>> cell(side * side * side, {-1, -1, -1});
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z) {
        const std::uint32_t place = HilbertCurve::place_of_cell(x, y, z);
        ASSERT_LT(place, cell.size());
        ASSERT_EQ(cell[place][0], -1);
        cell[place] = {static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)};
      }
  for (std::size_t i = 1; i < cell.size(); ++i) {
    int steps = 0;
    for (std::size_t k = 0; k < 3; ++k) steps += std::abs(cell[i][k] - cell[i - 1][k]);
    ASSERT_EQ(steps, 1) << i;
  }
}

TEST(HilbertCurve, WhatIsOutsideIsInACellOfTheEdge) {
  const HilbertCurve curve(Box{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(curve(Vec3{-1e300, -1, -1}), curve(Vec3{0, 0, 0}));
  EXPECT_EQ(curve(Vec3{1e300, 2, 2}), curve(Vec3{1, 1, 1}));
}

std::vector<std::uint64_t> keys_of_a_sheet(int side) {
  const double size = side;
  return keys_along_curve(
      static_cast<std::size_t>(side) * side, Box{{0, 0, 0}, {float(size), float(size), 1}},
      [&](std::size_t i) {
        return Vec3{double(i % std::size_t(side)), double(i / std::size_t(side)), 0.1};
      });
}

// Sizes of groups, after a look at what holds for any.
std::vector<std::size_t> sizes(const std::vector<std::uint64_t>& keys, std::size_t least,
                               std::size_t most) {
  std::vector<std::uint32_t> ends;
  add_groups_along_curve(keys, least, most, 7, ends);
  std::vector<std::size_t> result;
  std::size_t from = 7;
  for (const std::uint32_t end : ends) {
    EXPECT_GT(end, from);
    EXPECT_LE(end - from, most + 2 * least);
    result.push_back(end - from);
    from = end;
  }
  EXPECT_EQ(from, 7 + keys.size());
  return result;
}

TEST(CurveGroups, OfASheetAreSquares) {
  // 64 x 64 places: cubes of the grid hold squares of 8 x 8.
  EXPECT_EQ(sizes(keys_of_a_sheet(64), 16, 64), std::vector<std::size_t>(64, 64));
}

TEST(CurveGroups, NoneIsSmallButThatOfAll) {
  for (const int side : {3, 7, 20, 33, 61, 100}) {
    const std::vector<std::size_t> all = sizes(keys_of_a_sheet(side), 32, 192);
    for (const std::size_t size : all)
      EXPECT_TRUE(size >= 32 || all.size() == 1) << side << ": " << size;
  }
  EXPECT_TRUE(sizes({}, 32, 192).empty());
}

TEST(CurveGroups, OfOneCellAreCutAnywhere) {
  EXPECT_EQ(sizes(std::vector<std::uint64_t>(1000, 5), 1, 100), std::vector<std::size_t>(10, 100));
}

}  // namespace
}  // namespace sectile
