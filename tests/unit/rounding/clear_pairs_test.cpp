// Pairs of triangles of which doubles tell that they meet in common corners only, against exact
// rational numbers.
#include "rounding/clear_pairs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "lattice_triangles.h"

namespace sectile {
namespace {

using namespace lattice;

class Pairs {
 public:
  /// The same pair with each corner up to `slack` away in each coordinate, those in common alike.
  std::pair<Corners, Corners> moved(std::pair<Corners, Corners> pair, std::size_t common,
                                    std::int64_t slack) {
    for (Corners* t : {&pair.first, &pair.second})
      for (Point& p : *t)
        for (std::int64_t& c : p)
          c += static_cast<std::int64_t>(random_() % std::uint64_t(2 * slack + 1)) - slack;
    for (std::size_t i = 0; i < common; ++i) pair.second[i] = pair.first[i];
    return pair;
  }

  /// The first corners of both are the same.
  std::pair<Corners, Corners> next(std::size_t common, std::int64_t size) {
    std::pair<Corners, Corners> pair{triangle(size), triangle(size)};
    for (std::size_t i = 0; i < common; ++i) pair.second[i] = pair.first[i];
    return pair;
  }

 private:
  Corners triangle(std::int64_t size) {
    Corners t;
    for (Point& p : t)
      for (std::int64_t& c : p) c = static_cast<std::int64_t>(random_() % std::uint64_t(size));
    return t;
  }
  std::mt19937_64 random_{23};
};

// Each point has a number of its own.
PlacedTriangle placed(const Corners& t, double scale) {
  PlacedTriangle result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.vertex[i] = static_cast<std::uint32_t>((t[i][0] * 1024 + t[i][1]) * 1024 + t[i][2]);
    result.at[i] = {double(t[i][0]) * scale, double(t[i][1]) * scale, double(t[i][2]) * scale};
  }
  return result;
}

TEST(ClearPairs, MeetInCommonCornersOnly) {
  Pairs pairs;
  for (const std::int64_t size : {3, 5, 20, 1000})
    for (const std::size_t common : {0u, 1u, 2u})
      for (const double scale : {1.0, 0x1p-40, 0x1p300, 0x1p-400}) {
        int told = 0;
        for (int i = 0; i < 5000; ++i) {
          const auto [s, t] = pairs.next(common, size);
          const PlacedTriangle first = placed(s, scale), second = placed(t, scale);
          const ViewedTriangle viewed(first, 0);
          EXPECT_TRUE(!viewed.view.clear() || normal_of(s) != (Point{0, 0, 0}));
          if (!viewed.view.clear() || !clearly_meet_in_corners(viewed, {second, 0}, 0)) continue;
          ++told;
          EXPECT_FALSE(normal_of(t) != (Point{0, 0, 0}) && meet_in_more(s, t))
              << "size " << size << ", " << common << " in common, pair " << i;
        }
        if (scale == 1.0) {
          EXPECT_GT(told, 500) << "size " << size << ", " << common << " in common";
        }
      }
}

// Of those that meet in nothing else, and whose planes and edges are clear of each other.
TEST(ClearPairs, NearlyAllAreTold) {
  Pairs pairs;
  for (const std::size_t common : {0u, 1u, 2u}) {
    int apart = 0, told = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto [s, t] = pairs.next(common, 1000);
      if (meet_in_more(s, t)) continue;
      ++apart;
      const PlacedTriangle first = placed(s, 1 / 3.0), second = placed(t, 1 / 3.0);
      told += clearly_meet_in_corners({first, 0}, {second, 0}, 0);
    }
    EXPECT_GT(told, 0.99 * apart) << common << " in common";
    EXPECT_GT(apart, 1000);
  }
}

// What is told with a slack holds wherever the corners are that near.
TEST(ClearPairs, WithASlackAreApartWhereverTheirCornersWere) {
  Pairs pairs;
  for (const std::int64_t slack : {1, 5})
    for (const std::size_t common : {0u, 1u, 2u}) {
      int told = 0;
      for (int i = 0; i < 5000; ++i) {
        const auto pair = pairs.next(common, 1000);
        const ViewedTriangle first(placed(pair.first, 1), double(slack)),
            second(placed(pair.second, 1), double(slack));
        if (!first.view.clear() || !clearly_meet_in_corners(first, second, double(slack))) continue;
        ++told;
        for (int k = 0; k < 10; ++k) {
          const auto [s, t] = pairs.moved(pair, common, slack);
          EXPECT_NE(normal_of(s), (Point{0, 0, 0}));
          EXPECT_FALSE(normal_of(t) != (Point{0, 0, 0}) && meet_in_more(s, t))
              << "slack " << slack << ", " << common << " in common, pair " << i;
        }
      }
      EXPECT_GT(told, 2000) << common << " in common";
    }
}

TEST(ClearPairs, NoneIsToldWithASlackThatReachesAcross) {
  const PlacedTriangle s{{0, 1, 2}, {Vec3{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}},
      t{{3, 4, 5}, {Vec3{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}};
  EXPECT_TRUE(clearly_meet_in_corners({s, 0x1p-6}, {t, 0x1p-6}, 0x1p-6));
  EXPECT_FALSE(clearly_meet_in_corners({s, 0.5}, {t, 0.5}, 0.5));
}

TEST(ClearPairs, NeighboursInOnePlaneAreTold) {
  const ViewedTriangle s({{0, 1, 2}, {Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0);
  ASSERT_TRUE(s.view.clear());
  const auto told = [&](const PlacedTriangle& t) { return clearly_meet_in_corners(s, {t, 0}, 0); };
  EXPECT_TRUE(told({{2, 1, 3}, {Vec3{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}}));
  EXPECT_TRUE(told({{0, 2, 4}, {Vec3{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}}));
  EXPECT_TRUE(told({{0, 4, 5}, {Vec3{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}));
  EXPECT_FALSE(told({{2, 1, 3}, {Vec3{0, 1, 0}, {1, 0, 0}, {0.25, 0.25, 0}}}));  // folded back
  // Another vertex at the same place.
  EXPECT_FALSE(told({{6, 4, 5}, {Vec3{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}));
}

TEST(ClearPairs, WhatHasTwoCornersInOneIsNotTold) {
  const PlacedTriangle s{{0, 1, 2}, {Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    PlacedTriangle t{{3, 4, 5}, {Vec3{-1, 0, 0}, {0, 0, 5}, {0, 0, 7}}};
    for (const std::size_t k : {i, (i + 1) % 3}) t.vertex[k] = s.vertex[i], t.at[k] = s.at[i];
    EXPECT_FALSE(clearly_meet_in_corners({s, 0}, {t, 0}, 0));
  }
}

}  // namespace
}  // namespace sectile
