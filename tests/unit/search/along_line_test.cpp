// What doubles tell about directions around a line is right, where they tell anything.
#include "search/along_line.h"

#include <gtest/gtest.h>

#include <random>

namespace sectile {
namespace {

// Whole numbers so small that doubles make no error.
Vec3 random_point(std::mt19937& random, int size) {
  const auto below = [&] {
    return static_cast<double>(random() % static_cast<unsigned>(2 * size + 1)) - size;
  };
  const double x = below(), y = below(), z = below();
  return {x, y, z};
}

Vec3 difference(const Vec3& p, const Vec3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

Sign exact_turn(const Vec3& from, const Vec3& to, const Vec3& p, const Vec3& q) {
  const Vec3 d = difference(to, from), u = difference(p, from), v = difference(q, from);
  return sign_of(d.x * (u.y * v.z - u.z * v.y) + d.y * (u.z * v.x - u.x * v.z) +
                 d.z * (u.x * v.y - u.y * v.x));
}

TEST(AlongLine, TurnsAreThoseOfWholeNumbers) {
  std::mt19937 random(1);
  int told = 0, straight = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 from = random_point(random, 6), to = random_point(random, 6),
               p = random_point(random, 6), q = random_point(random, 6);
    if (from == to) continue;
    const AlongLine line(from, to);
    const Sign exact = exact_turn(from, to, p, q), turn = line.turn(p, q);
    if (exact == Sign::zero) {
      EXPECT_EQ(turn, Sign::zero);
      ++straight;
    } else if (turn != Sign::zero) {
      EXPECT_EQ(turn, exact);
      ++told;
    }
  }
  EXPECT_GT(told, 18000);
  EXPECT_GT(straight, 100);
}

TEST(AlongLine, TurnsThatDoublesDoNotTellAreZero) {
  const AlongLine line({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 3, 1e6 - 2});
  const Vec3 p{1e6 + 0.7, 1e6 + 0.1, 1e6 + 0.9};
  EXPECT_EQ(line.turn(p, p), Sign::zero);
  EXPECT_EQ(line.turn(p, {p.x + 1e-9, p.y, p.z}), Sign::zero);
  EXPECT_NE(line.turn(p, {p.x + 1e-3, p.y, p.z}), Sign::zero);
}

TEST(AlongLine, PointsFollowEachOther) {
  const AlongLine line({5, 1, 0}, {1, 0, 0});
  EXPECT_EQ(line.along({5, 1, 0}, {1, 0, 0}), Sign::positive);
  EXPECT_EQ(line.along({1, 0, 0}, {3, 0.5, 0}), Sign::negative);
  EXPECT_EQ(line.along({3, 0.5, 0}, {3, 0.5, 0}), Sign::zero);
}

}  // namespace
}  // namespace sectile
