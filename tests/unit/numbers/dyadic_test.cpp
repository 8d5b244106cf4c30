#include "numbers/dyadic.h"

#include <gtest/gtest.h>

#include "unit/rational.h"

namespace sectile::test {
namespace {

TEST(Dyadic, SumsAndProductsHaveTheSignOfTheRationals) {
  AnyDouble any(1);
  for (int i = 0; i < 20000; ++i) {
    const double a = any(), b = any(), c = any(), d = any(), e = any();
    const Dyadic x = (Dyadic(a) * Dyadic(b) - Dyadic(c) * Dyadic(d)) * (Dyadic(a) + Dyadic(e)) -
                     Dyadic(e) * Dyadic(b);
    const Rational y =
        (rational(a) * rational(b) - rational(c) * rational(d)) * (rational(a) + rational(e)) -
        rational(e) * rational(b);
    ASSERT_EQ(x.sign(), rational_sign(y)) << a << ' ' << b << ' ' << c << ' ' << d << ' ' << e;
  }
}

TEST(Dyadic, DifferencesOfEqualNumbersVanish) {
  AnyDouble any(2);
  for (int i = 0; i < 5000; ++i) {
    const double a = any(), b = any(), c = any();
    const Dyadic left = (Dyadic(a) + Dyadic(b)) * Dyadic(c);
    const Dyadic right = Dyadic(a) * Dyadic(c) + Dyadic(b) * Dyadic(c);
    ASSERT_EQ((left - right).sign(), Sign::zero);
  }
}

TEST(Dyadic, RoundsToNearest) {
  AnyDouble any(3);
  for (int i = 0; i < 5000; ++i) {
    const double a = any(), b = any(), c = any();
    const Dyadic x = Dyadic(a) * Dyadic(b) + Dyadic(c);
    ASSERT_EQ(x.nearest(), nearest(rational(a) * rational(b) + rational(c)));
  }
}

TEST(Dyadic, QuotientsAreRoundedCorrectly) {
  AnyDouble any(4);
  for (int i = 0; i < 5000; ++i) {
    const double a = any(), b = any(), c = any(), d = any();
    const Rational below = rational(c) * rational(d) + rational(a);
    if (below == 0) continue;
    const Rational wanted = rational(a) * rational(b) / below;
    if (abs(wanted) > Rational(Integer(1) << 1000u)) continue;
    ASSERT_EQ(nearest_quotient(Dyadic(a) * Dyadic(b), Dyadic(c) * Dyadic(d) + Dyadic(a)),
              nearest(wanted));
  }
}

TEST(Dyadic, LongNumbersSurviveCopyingAndMoving) {
  Dyadic x(1.0);
  for (int i = 0; i < 40; ++i) x = x * Dyadic(1 + 0x1p-52);
  const Dyadic copy = x;
  Dyadic moved = std::move(x);
  EXPECT_EQ((copy - moved).sign(), Sign::zero);
  moved = moved * Dyadic(2.0);
  EXPECT_EQ((moved - copy).sign(), Sign::positive);
}

TEST(SignOfDot, AgreesWithRationals) {
  AnyDouble any(5);
  for (int i = 0; i < 20000; ++i) {
    double a[4], b[4];
    Rational sum = 0;
    for (int k = 0; k < 4; ++k) {
      a[k] = any();
      b[k] = any();
      sum += rational(a[k]) * rational(b[k]);
    }
    ASSERT_EQ(sign_of_dot(a, b, 4), rational_sign(sum));
  }
}

}  // namespace
}  // namespace sectile::test
