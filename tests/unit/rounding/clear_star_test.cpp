// Vertices of which doubles tell that their triangles meet in common corners only, against exact
// integers.
#include "rounding/clear_star.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "lattice_triangles.h"

namespace sectile {
namespace {

using namespace lattice;

struct Star {
  Point vertex{0, 0, 0};
  std::vector<Point> ring;  // the other corners, around it; consecutive ones span a triangle

  std::vector<Corners> triangles() const {
    std::vector<Corners> all;
    for (std::size_t i = 0; i < ring.size(); ++i)
      all.push_back({vertex, ring[i], ring[(i + 1) % ring.size()]});
    return all;
  }
};

Vec3 placed(const Point& p, double scale) {
  return {double(p[0]) * scale, double(p[1]) * scale, double(p[2]) * scale};
}

bool is_told(const std::vector<Corners>& triangles, double slack = 0, double scale = 1) {
  std::vector<StarTriangle> star;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 p = placed(a, scale), q = placed(b, scale), r = placed(c, scale);
    star.push_back({Facing(PlaneWithSlack(p, q, r, slack * scale)), q, r});
  }
  return is_clear_star(placed(triangles[0][0], scale), star);
}
bool is_told(const Star& star, double slack = 0, double scale = 1) {
  return is_told(star.triangles(), slack, scale);
}

bool is_legal(const Star& star) {
  const std::vector<Corners> all = star.triangles();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (normal_of(all[i]) == Point{0, 0, 0}) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (meet_in_more(all[i], all[j])) return false;
  }
  return true;
}

class Stars : RandomPoints {
 public:
  using RandomPoints::RandomPoints;

  Star any(std::size_t count, std::int64_t size) {
    Star star{point(size / 4), {}};
    for (std::size_t i = 0; i < count; ++i) star.ring.push_back(point(size));
    return star;
  }
  /// Goes around the z axis a number of times, up and down.
  Star around(std::size_t count, int times, std::int64_t height) {
    Star star;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * double(i) * times / double(count);
      star.ring.push_back({std::llround(900 * std::cos(angle)), std::llround(900 * std::sin(angle)),
                           number(height)});
    }
    return star;
  }
  /// Each corner up to `slack` away in each coordinate.
  Star moved(Star star, std::int64_t slack) {
    const auto move = [&](Point& p) {
      for (std::int64_t& c : p) c += number(slack);
    };
    move(star.vertex);
    for (Point& p : star.ring) move(p);
    return star;
  }
};

TEST(ClearStar, ItsTrianglesMeetInCommonCornersOnly) {
  Stars stars(3);
  for (const std::int64_t size : {2, 4, 20, 1000})
    for (const std::size_t count : {3u, 4u, 5u, 7u}) {
      int told = 0;
      for (int i = 0; i < 4000; ++i) {
        const Star star = stars.any(count, size);
        for (const double scale : {1.0, 0x1p-40, 0x1p300, 0x1p-400, 0x1p-541}) {
          if (!is_told(star, 0, scale)) continue;
          ++told;
          ASSERT_TRUE(is_legal(star)) << "size " << size << ", " << count << " corners, star " << i;
        }
      }
      EXPECT_GT(told, 20) << "size " << size << ", " << count << " corners";
    }
}

TEST(ClearStar, WithASlackIsClearWhereverItsCornersWere) {
  Stars stars(5);
  for (const std::int64_t slack : {1, 5, 40}) {
    int told = 0;
    for (int i = 0; i < 3000; ++i) {
      const Star star = i % 2 == 0 ? stars.any(4, 300) : stars.around(6, 1, 1500);
      if (!is_told(star, double(slack))) continue;
      ++told;
      for (int k = 0; k < 20; ++k)
        ASSERT_TRUE(is_legal(stars.moved(star, slack))) << "slack " << slack << ", star " << i;
    }
    EXPECT_GT(told, 100) << "slack " << slack;
  }
}

// 100 wide: with its vertex and a corner half of that off, a triangle may be turned over.
TEST(ClearStar, IsNotToldWithASlackThatReachesAcross) {
  const Star star{{0, 0, 0}, {{100, 0, 0}, {0, 100, 0}, {-100, 0, 0}, {0, -100, 0}}};
  EXPECT_TRUE(is_told(star, 1));
  EXPECT_FALSE(is_told(star, 50));
}

TEST(ClearStar, NearlyAllThatAreSeenFromOneSideAreTold) {
  Stars stars(7);
  int told = 0;
  for (int i = 0; i < 2000; ++i)
    told += is_told(stars.around(4 + static_cast<std::size_t>(i % 9), 1, 500), 0, 1 / 3.0);
  EXPECT_GT(told, 1960);
}

// Its triangles all look up, and meet.
TEST(ClearStar, IsNotToldIfItGoesAroundTwice) {
  Stars stars(9);
  for (const std::size_t count : {7u, 9u, 11u})
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(is_told(stars.around(count, 2, 300)));
}

TEST(ClearStar, OfTwoSheetsIsNotTold) {
  const Star below{{0, 0, 0}, {{9, 0, -1}, {0, 9, -1}, {-9, -9, -1}}},
      above{{0, 0, 0}, {{9, 0, 1}, {0, 9, 1}, {-9, -9, 1}}};
  EXPECT_TRUE(is_told(below));
  EXPECT_TRUE(is_told(above));
  std::vector<Corners> both = below.triangles();
  for (const Corners& t : above.triangles()) both.push_back(t);
  EXPECT_FALSE(is_told(both));
}

TEST(ClearStar, IsToldInAnyOrderAndFromBehind) {
  std::vector<Corners> triangles =
      Star{{1, 1, 1}, {{9, 0, 0}, {0, 9, 0}, {-9, 0, 0}, {0, -9, 0}}}.triangles();
  std::swap(triangles[0], triangles[2]);
  EXPECT_TRUE(is_told(triangles));
  for (auto& [a, b, c] : triangles) std::swap(b, c);
  EXPECT_TRUE(is_told(triangles));
  std::swap(triangles[1][1], triangles[1][2]);  // one is turned over
  EXPECT_FALSE(is_told(triangles));
}

TEST(ClearStar, WithATriangleWithoutAreaIsNotTold) {
  EXPECT_FALSE(is_told(Star{{0, 0, 0}, {{9, 0, 0}, {0, 9, 0}, {-9, 0, 0}, {-4, 0, 0}}}));
  EXPECT_FALSE(is_told(Star{{0, 0, 0}, {{9, 0, 0}, {0, 9, 0}, {0, 9, 0}, {-9, -9, 0}}}));
}

}  // namespace
}  // namespace sectile
