// A point and the plane of three near it, against exact determinants.
#include "geometry/four_points.h"

#include <gtest/gtest.h>

#include <random>

#include "numbers/dyadic.h"

namespace sectile {
namespace {

Dyadic difference(double a, double b) {
  return Dyadic(a) - Dyadic(b);
}

bool share_a_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Dyadic u[3] = {difference(a.x, d.x), difference(a.y, d.y), difference(a.z, d.z)},
               v[3] = {difference(b.x, d.x), difference(b.y, d.y), difference(b.z, d.z)},
               w[3] = {difference(c.x, d.x), difference(c.y, d.y), difference(c.z, d.z)};
  Dyadic sum;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    sum += u[k] * (v[i] * w[j] - v[j] * w[i]);
  }
  return sum.sign() == Sign::zero;
}

// Points of a plane through the origin, moved far away and rounded, or moved by what is exact.
class NearPlane {
 public:
  double number() { return static_cast<double>(random_() % 2001) - 1000; }
  Vec3 point(double scale, double away) {
    const double s = number(), t = number();
    return {(3 * s + t) * scale + away, (s - 2 * t) * scale + away, (7 * s + 5 * t) * scale + away};
  }

 private:
  std::mt19937 random_{17};
};

TEST(FourPoints, AreNeverToldApartFromAPlaneThatTheyShare) {
  NearPlane near;
  int in_plane = 0, told = 0, off = 0;
  for (const double scale : {1.0, 0.1, 1e-3, 0x1p-1060, 0x1p-300, 0x1p300, 0x1p1000})
    for (const double away : {0.0, 1.0, 1e6, 0x1p40, 0x1p-1070})
      for (int i = 0; i < 300; ++i) {
        const Vec3 a = near.point(scale, away), b = near.point(scale, away),
                   c = near.point(scale, away), d = near.point(scale, away);
        const bool flat = share_a_plane(a, b, c, d), apart = clearly_off_plane(a, b, c, d);
        EXPECT_FALSE(flat && apart) << scale << ' ' << away;
        EXPECT_EQ(in_one_plane(a, b, c, d), flat) << scale << ' ' << away;
        in_plane += flat;
        off += !flat;
        told += apart;
      }
  EXPECT_GT(in_plane, 1000);
  EXPECT_GT(off, 1000);
  EXPECT_GT(told, 300);
}

bool share_a_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Dyadic u[3] = {difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)},
               v[3] = {difference(c.x, a.x), difference(c.y, a.y), difference(c.z, a.z)};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if ((u[i] * v[j] - u[j] * v[i]).sign() != Sign::zero) return false;
  }
  return true;
}

TEST(ThreePoints, AreNeverToldToBeBentWhereTheyShareALine) {
  NearPlane near;
  std::mt19937 random(5);
  int in_line = 0, bent = 0;
  for (const double scale : {1.0, 0.1, 0x1p-1060, 0x1p-300, 0x1p300, 0x1p1000})
    for (int i = 0; i < 500; ++i) {
      const Vec3 a = near.point(scale, 0), step = near.point(scale / 64, 0);
      const auto at = [&](double t) {
        return Vec3{a.x + t * step.x, a.y + t * step.y, a.z + t * step.z};
      };
      const Vec3 b = at(random() % 9), c = at(random() % 9 - 20.0);
      const bool straight = share_a_line(a, b, c), told = clearly_bent(a, b, c);
      EXPECT_FALSE(straight && told) << scale;
      in_line += straight;
      bent += told;
    }
  EXPECT_GT(in_line, 300);
  EXPECT_TRUE(clearly_bent({0, 0, 0}, {1, 0, 0}, {0, 1e-9, 0}));
  EXPECT_GT(bent, 0);
}

// What the plane's equation in doubles cannot tell: the corner of a small square that is off its
// plane by one rounding.
TEST(FourPoints, AreToldApartWhereTheyAreNearEachOther) {
  const Vec3 a{1, 1, 1}, b{1.001, 1, 1}, c{1.001, 1.001, 1}, d{1, 1.001, 1 + 0x1p-52};
  EXPECT_TRUE(clearly_off_plane(a, b, c, d));
}

}  // namespace
}  // namespace sectile
