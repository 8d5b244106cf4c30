// What a bounded number says is true of the exact number, for doubles of all kinds.
#include "numbers/bounded.h"

#include <gtest/gtest.h>

#include "number_samples.h"
#include "numbers/dyadic.h"

namespace sectile::test {
namespace {

struct Both {
  Bounded bounded;
  Dyadic exact;

  explicit Both(double value) : bounded(value), exact(value) {}
  Both(const Bounded& b, Dyadic e) : bounded(b), exact(std::move(e)) {}
  static Both difference(double a, double b) {
    return {Bounded::difference(a, b), Dyadic::difference(a, b)};
  }
  friend Both operator+(const Both& a, const Both& b) {
    return {a.bounded + b.bounded, a.exact + b.exact};
  }
  friend Both operator-(const Both& a, const Both& b) {
    return {a.bounded - b.bounded, a.exact - b.exact};
  }
  friend Both operator*(const Both& a, const Both& b) {
    return {a.bounded * b.bounded, a.exact * b.exact};
  }
};

using Source = double (NumberSamples::*)();

class BoundedNumber : public testing::Test {
 protected:
  void expect_true(const Both& number) {
    ++asked_;
    if (!number.bounded.decided()) return;
    ++decided_;
    EXPECT_EQ(number.bounded.sign(), number.exact.sign());
  }

  // Sums and products of several values, some of them nearly equal.
  Both expression(NumberSamples& samples, Source value, int depth) {
    if (depth == 0) {
      const double a = (samples.*value)();
      return samples.chance(3) ? Both::difference(a, samples.near(a)) : Both(a);
    }
    const Both a = expression(samples, value, depth - 1);
    const Both b = samples.chance(4) ? a : expression(samples, value, depth - 1);
    return samples.chance(2) ? a * b : samples.chance(2) ? a + b : a - b;
  }

  int asked_ = 0, decided_ = 0;
};

TEST_F(BoundedNumber, HasTheSignOfTheExactNumberOrNone) {
  NumberSamples samples(1);
  for (int i = 0; i < 200'000; ++i)
    expect_true(expression(samples, &NumberSamples::any, 1 + i % 4));
  EXPECT_GT(decided_, asked_ / 2);
}

TEST_F(BoundedNumber, DecidesNearlyAlwaysAmongNumbersOfLikeSize) {
  NumberSamples samples(2);
  for (int i = 0; i < 100'000; ++i) {
    const Both a(samples.full()), b(samples.full()), c(samples.full()), d(samples.full());
    expect_true((a - b) * (c - d) - (a - d) * (c - b));
  }
  EXPECT_EQ(decided_, asked_);
}

TEST_F(BoundedNumber, KeepsTheErrorOfTheLeastNumbers) {
  NumberSamples samples(3);
  for (int i = 0; i < 100'000; ++i) {
    const Both a(samples.tiny()), b(samples.tiny()), c(samples.full());
    expect_true(a * b);
    expect_true((a + b) * c - a * c);
    expect_true(a - b);
  }
  EXPECT_GT(decided_, 0);
}

TEST_F(BoundedNumber, AMinorThatIsZeroIsNotDecided) {
  NumberSamples samples(4);
  for (int i = 0; i < 10'000; ++i) {
    const Both a(samples.any()), b(samples.any());
    const Both zero = a * b - b * a;
    expect_true(zero);
  }
  EXPECT_EQ(decided_, 0);
}

TEST_F(BoundedNumber, WhatIsZeroInAnotherOrderOfSumsAndProductsIsNotDecided) {
  NumberSamples samples(8);
  for (int i = 0; i < 100'000; ++i) {
    const Both a(samples.full()), b(samples.full()), c(samples.full()), d(samples.full());
    expect_true((a * b) * (c * d) - (a * d) * (b * c));
    const Both p = a * b, q = b * c, r = c * d, s = d * a;
    expect_true(((p + q) + (r + s)) - ((p + s) + (q + r)));
    expect_true((a + b) * c * d - (a * (c * d) + b * d * c));
  }
  EXPECT_EQ(decided_, 0);
}

TEST_F(BoundedNumber, OverflowDecidesNothing) {
  const Bounded large(1e300);
  EXPECT_FALSE((large * large).decided());
  EXPECT_FALSE((large * large - large * large).decided());
  EXPECT_FALSE((Bounded(1.7e308) + Bounded(1.7e308)).decided());
  EXPECT_FALSE(nearest_quotient(large, Bounded(1e-300)).has_value());
}

TEST_F(BoundedNumber, QuotientsAreRoundedToNearestOrRefused) {
  NumberSamples samples(5);
  int rounded = 0, known_inexact = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Source value = i % 2 == 0 ? &NumberSamples::any : &NumberSamples::full;
    const Both n = expression(samples, value, i % 3), d = expression(samples, value, i % 3);
    if (d.exact.sign() == Sign::zero) continue;
    const auto quotient = nearest_quotient(n.bounded, d.bounded);
    if (!quotient) continue;
    ++rounded;
    const double expected = nearest_quotient(n.exact, d.exact);
    EXPECT_EQ(quotient->value, expected);
    EXPECT_EQ(std::signbit(quotient->value), std::signbit(expected));
    const bool exact = (Dyadic(expected) * d.exact - n.exact).sign() == Sign::zero;
    EXPECT_FALSE(quotient->inexact && exact);
    known_inexact += quotient->inexact;
  }
  EXPECT_GT(rounded, 50'000);
  EXPECT_GT(known_inexact, rounded / 2);
}

TEST_F(BoundedNumber, QuotientsByUncertainNumbersNearTheLeastAreRefused) {
  // The denominator has an error of 2^-10 of its size, and the product of that with the second
  // half of the quotient is below all doubles.
  NumberSamples samples(9);
  for (int i = 0; i < 1000; ++i) {
    const double tiny = std::ldexp(samples.full(), -1060), part = std::ldexp(samples.full(), -10);
    const Bounded uncertain = Bounded(tiny) * Bounded(part);
    const auto q = nearest_quotient(Bounded(tiny), uncertain);
    const double expected = nearest_quotient(Dyadic(tiny), Dyadic(tiny) * Dyadic(part));
    if (q) {
      EXPECT_EQ(q->value, expected);
    }
  }
}

TEST_F(BoundedNumber, QuotientsInTheMiddleBetweenTwoDoublesAreLeftToExactNumbers) {
  NumberSamples samples(6);
  for (int i = 0; i < 10'000; ++i) {
    const double d = samples.full(), q = samples.full();
    const Bounded middle = Bounded(q) + Bounded(std::ldexp(1.0, std::ilogb(q) - 53));
    EXPECT_FALSE(nearest_quotient(middle * Bounded(d), Bounded(d)).has_value());
  }
}

TEST_F(BoundedNumber, QuotientsOfFullNumbersAreNearlyAlwaysKnown) {
  NumberSamples samples(7);
  for (int i = 0; i < 10'000; ++i)
    EXPECT_TRUE(nearest_quotient(Bounded(samples.full()), Bounded(samples.full())).has_value());
}

}  // namespace
}  // namespace sectile::test
