// The public triangulation: polygons with holes, bent ones, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "sectile/sectile.h"

namespace sectile {
namespace {

// Along `normal`, which has length one.
double area_along(const std::vector<Vec3>& corners, const std::vector<CornerTriangle>& triangles,
                  const Vec3& normal) {
  double sum = 0;
  for (const CornerTriangle& t : triangles) {
    const Vec3 &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
    const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const double here = normal.x * (u.y * v.z - u.z * v.y) + normal.y * (u.z * v.x - u.x * v.z) +
                        normal.z * (u.x * v.y - u.y * v.x);
    EXPECT_GE(here, 0);
    sum += 0.5 * here;
  }
  return sum;
}

TEST(PolygonTriangles, TakeTwoHolesAndCornersInLine) {
  std::vector<Vec3> corners = {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0},
                               {1, 1, 0}, {1, 4, 0}, {4, 4, 0},  {4, 1, 0},  {6, 2, 0},
                               {6, 5, 0}, {9, 5, 0}, {9, 2, 0}};
  const std::vector<std::uint32_t> loop_ends = {5, 9, 13};
  EXPECT_DOUBLE_EQ(area_along(corners, triangulate(corners, loop_ends), {0, 0, 1}), 60 - 9 - 9);
  // Upright, and seen from behind.
  for (Vec3& p : corners) p = {0, p.y, p.x};
  EXPECT_DOUBLE_EQ(area_along(corners, triangulate(corners, loop_ends), {-1, 0, 0}), 60 - 9 - 9);
}

TEST(PolygonTriangles, HolesMayTouchTheOutline) {
  const std::vector<Vec3> corners = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1},
                                     {2, 0, 1}, {1, 2, 1}, {3, 2, 1}};
  const std::vector<std::uint32_t> loop_ends = {4, 7};
  EXPECT_DOUBLE_EQ(area_along(corners, triangulate(corners, loop_ends), {0, 0, 1}), 14);
}

TEST(PolygonTriangles, TakeAHundredHolesWithoutComparingThemAll) {
  std::vector<Vec3> corners = {{0, 0, 0}, {400, 0, 0}, {400, 400, 0}, {0, 400, 0}};
  std::vector<std::uint32_t> loop_ends = {4};
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const double x = 4 * i + 1, y = 4 * j + 1;
      for (const Vec3& p : {Vec3{x, y, 0}, {x, y + 2, 0}, {x + 2, y + 2, 0}, {x + 2, y, 0}})
        corners.push_back(p);
      loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
  EXPECT_DOUBLE_EQ(area_along(corners, triangulate(corners, loop_ends), {0, 0, 1}),
                   160000 - 4 * 10000);
}

TEST(PolygonTriangles, NeedNotBeFlat) {
  const std::vector<Vec3> corners = {
      {0, 0, 0}, {2, 0, 0.5}, {2, 2, 0}, {1, 0.5, 0.25}, {0, 2, 0.5}};
  const std::vector<std::uint32_t> one = {5};
  EXPECT_DOUBLE_EQ(area_along(corners, triangulate(corners, one), {0, 0, 1}), 4 - 1.5);
}

TEST(PolygonTriangles, RefuseInSentences) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> none, empty = {0, 4}, few = {3}, all = {4};
  EXPECT_THROW(triangulate(square, none), std::invalid_argument);
  EXPECT_THROW(triangulate(square, empty), std::invalid_argument);
  EXPECT_THROW(triangulate(square, few), std::invalid_argument);
  std::vector<Vec3> odd = square;
  odd[2].z = std::nan("");
  EXPECT_THROW(triangulate(odd, all), std::invalid_argument);
  // A hole that crosses the outline.
  std::vector<Vec3> crossed = square;
  for (const Vec3& p : {Vec3{0.5, 0.5, 0}, {0.5, 0.7, 0}, {2, 0.7, 0}, {2, 0.5, 0}})
    crossed.push_back(p);
  const std::vector<std::uint32_t> two = {4, 8};
  EXPECT_THROW(triangulate(crossed, two), InvalidSolid);
}

}  // namespace
}  // namespace sectile
