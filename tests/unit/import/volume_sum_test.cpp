// The volume that triangles enclose, beside exact numbers.
#include "import/volume_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "numbers/dyadic.h"

namespace sectile {
namespace {

Dyadic exact_term(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto from_origin = [&](const Vec3& v, Dyadic(&to)[3]) {
    to[0] = Dyadic(v.x) - Dyadic(o.x);
    to[1] = Dyadic(v.y) - Dyadic(o.y);
    to[2] = Dyadic(v.z) - Dyadic(o.z);
  };
  Dyadic p[3], q[3], r[3];
  from_origin(a, p);
  from_origin(b, q);
  from_origin(c, r);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

// Flat triangles, whose terms cancel, and others, of sizes down to where products underflow.
TEST(VolumeSum, IsNoFartherFromTheExactOneThanItsBound) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const int exponent : {0, 60, -60, -300, -345, -358})
    for (const double thickness : {1.0, 1e-8, 0x1p-50, 0.0})
      for (const int count : {1, 3, 1000}) {
        const double size = std::ldexp(1.0, exponent);
        const auto corner = [&] {
          const double x = share(random), y = share(random);
          return Vec3{size * x, size * y, size * (x / 3 + y / 7 + thickness * share(random))};
        };
        const Vec3 o = corner();
        VolumeSum sum;
        Dyadic exact;
        for (int i = 0; i < count; ++i) {
          const Vec3 a = corner(), b = corner(), c = corner();
          sum.add(o, a, b, c);
          exact += exact_term(o, a, b, c);
        }
        const Dyadic off = Dyadic(sum.value()) - exact;
        EXPECT_NE((off - Dyadic(sum.error())).sign(), Sign::positive);
        EXPECT_NE((off + Dyadic(sum.error())).sign(), Sign::negative);
        if (thickness == 1 && exponent == 0) {
          EXPECT_LT(sum.error(), 1e-9 * count);
        }
      }
}

TEST(VolumeSum, SaysNothingWhereDoublesEnd) {
  VolumeSum sum;
  sum.add({0, 0, 0}, {0x1p400, 0, 0}, {0, 0x1p400, 0}, {0, 0, 0x1p400});
  EXPECT_FALSE(sum.value() > sum.error());
}

}  // namespace
}  // namespace sectile
