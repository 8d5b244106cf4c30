// Every bit of dyadic numbers against integers of boost::multiprecision.
#include "numbers/dyadic.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "number_samples.h"
#include "reference_number.h"

namespace sectile::test {
namespace {

// Taken to pieces of 53 bits.
Reference exact_value(Dyadic number) {
  Reference total, unit(1.0);
  while (number.sign() != Sign::zero) {
    const double piece = number.nearest();
    if (std::isinf(piece)) {
      number *= Dyadic(0x1p-1000);
      unit = unit * Reference(0x1p1000);
    } else if (std::abs(piece) < 0x1p-900) {
      number *= Dyadic(0x1p1000);
      unit = unit * Reference(0x1p-1000);
    } else {
      total = total + Reference(piece) * unit;
      number -= Dyadic(piece);
    }
  }
  return total;
}

struct Both {
  Dyadic number;
  Reference reference;

  explicit Both(double value) : number(value), reference(value) {}
  Both(Dyadic n, Reference r) : number(std::move(n)), reference(std::move(r)) {}
};

Both operator+(const Both& a, const Both& b) {
  return {a.number + b.number, a.reference + b.reference};
}
Both operator-(const Both& a, const Both& b) {
  return {a.number - b.number, a.reference - b.reference};
}
Both operator*(const Both& a, const Both& b) {
  return {a.number * b.number, a.reference * b.reference};
}

// A sum of products of up to `factors` doubles.
Both polynomial(NumberSamples& samples, int terms, int factors) {
  Both sum(0.0);
  for (int i = 0; i < terms; ++i) {
    Both product(samples.any());
    for (int j = 1; j < factors; ++j) product = product * Both(samples.any());
    sum = samples.chance(2) ? sum + product : sum - product;
  }
  return sum;
}

// No double is nearer to numerator / denominator than `rounded`, nor as near and even.
void expect_rounded(const Reference& numerator, const Reference& denominator, double rounded) {
  ASSERT_FALSE(std::isnan(rounded));
  const double largest = std::numeric_limits<double>::max(), infinite = HUGE_VAL;
  const Reference half(0.5), beyond = Reference(largest) + Reference(0x1p970);
  const bool even = std::isinf(rounded) || (std::bit_cast<std::uint64_t>(rounded) & 1u) == 0;
  const auto quotient_less = [&](const Reference& bound) {
    return (numerator - bound * denominator).sign() * denominator.sign();
  };
  const double below = std::nextafter(rounded, -infinite),
               above = std::nextafter(rounded, infinite);
  if (rounded != -infinite) {
    const Reference middle = rounded == infinite ? beyond
                             : std::isinf(below) ? -beyond
                                                 : (Reference(below) + Reference(rounded)) * half;
    const Sign s = quotient_less(middle);
    EXPECT_TRUE(s == Sign::positive || (s == Sign::zero && even)) << rounded;
  }
  if (rounded != infinite) {
    const Reference middle = rounded == -infinite ? -beyond
                             : std::isinf(above)  ? beyond
                                                  : (Reference(above) + Reference(rounded)) * half;
    const Sign s = quotient_less(middle);
    EXPECT_TRUE(s == Sign::negative || (s == Sign::zero && even)) << rounded;
  }
}

TEST(Dyadic, IsTheDouble) {
  NumberSamples samples(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = samples.any();
    const Dyadic number(value);
    EXPECT_EQ(number.nearest(), value);
    EXPECT_EQ(number.sign(), sign_of(value));
    EXPECT_TRUE(exact_value(number) == Reference(value)) << value;
  }
}

TEST(Dyadic, SumsOfTwoAreExact) {
  NumberSamples samples(2);
  for (int i = 0; i < 20000; ++i) {
    const Both a(samples.any()), b(samples.near(a.number.nearest()));
    EXPECT_TRUE(exact_value(a.number + b.number) == a.reference + b.reference);
    EXPECT_TRUE(exact_value(a.number - b.number) == a.reference - b.reference);
    EXPECT_EQ((a.number - b.number).sign(), (a.reference - b.reference).sign());
  }
}

TEST(Dyadic, PolynomialsAreExact) {
  NumberSamples samples(3);
  for (int i = 0; i < 4000; ++i) {
    const Both a = polynomial(samples, 1 + i % 4, 1 + i % 7), b = polynomial(samples, 2, 1 + i % 5);
    const Both sum = a + b, difference = a - b, product = a * b;
    EXPECT_TRUE(exact_value(sum.number) == sum.reference);
    EXPECT_TRUE(exact_value(difference.number) == difference.reference);
    EXPECT_TRUE(exact_value(product.number) == product.reference);
    EXPECT_EQ(difference.number.sign(), difference.reference.sign());
    EXPECT_TRUE(exact_value(-product.number) == -product.reference);
  }
}

TEST(Dyadic, CancellationLeavesTheSmallRest) {
  NumberSamples samples(4);
  for (int i = 0; i < 4000; ++i) {
    const Both a = polynomial(samples, 2, 1 + i % 6), small(samples.any());
    const Both difference = (a + small) - a;
    EXPECT_TRUE(exact_value(difference.number) == small.reference);
    EXPECT_EQ((a.number * small.number - small.number * a.number).sign(), Sign::zero);
    EXPECT_EQ(((a + small) * (a - small) - a * a + small * small).number.sign(), Sign::zero);
  }
}

TEST(Dyadic, CarriesAndBorrowsRunThroughAllLimbs) {
  for (int bits = 1; bits < 2400; ++bits) {
    Dyadic power(1.0);
    for (int left = bits; left > 0; left -= 1000)
      power *= Dyadic(std::ldexp(1.0, std::min(left, 1000)));
    const Dyadic ones = power - Dyadic(1.0);
    EXPECT_TRUE(exact_value(ones) == Reference((cpp_int(1) << bits) - 1, 0)) << bits;
    EXPECT_TRUE(exact_value(ones * ones) ==
                Reference(((cpp_int(1) << bits) - 1) * ((cpp_int(1) << bits) - 1), 0))
        << bits;
    EXPECT_TRUE(ones + Dyadic(1.0) == power) << bits;
    EXPECT_TRUE(ones < power);
    EXPECT_TRUE(-ones > -power);
  }
}

TEST(Dyadic, CopiesAndMovesKeepTheValue) {
  NumberSamples samples(5);
  std::vector<Both> numbers;
  for (int factors = 1; factors < 40; ++factors) {
    Both product(samples.full());
    for (int i = 1; i < factors; ++i) product = product * Both(samples.full());
    numbers.push_back(product);
  }
  for (const Both& a : numbers) {
    for (const Both& b : numbers) {
      Dyadic to(b.number);
      to = a.number;
      EXPECT_TRUE(exact_value(to) == a.reference);
      Dyadic moved(std::move(to));
      EXPECT_TRUE(exact_value(moved) == a.reference);
      Dyadic target(b.number);
      target = std::move(moved);
      EXPECT_TRUE(exact_value(target) == a.reference);
      const Dyadic& self = target;
      target = self;
      EXPECT_TRUE(exact_value(target) == a.reference);
      target -= b.number;
      target *= target;
      const Reference difference = a.reference - b.reference;
      EXPECT_TRUE(exact_value(target) == difference * difference);
    }
  }
}

TEST(Dyadic, NearestIsCorrectlyRounded) {
  NumberSamples samples(6);
  for (int i = 0; i < 20000; ++i) {
    const Both a = polynomial(samples, 1 + i % 3, 1 + i % 3);
    expect_rounded(a.reference, Reference(1.0), a.number.nearest());
  }
}

// Values at, just below and just above the middle between two doubles.
TEST(Dyadic, NearestDecidesTies) {
  NumberSamples samples(7);
  for (int i = 0; i < 20000; ++i) {
    const double value = samples.any(), next = std::nextafter(value, HUGE_VAL);
    if (std::isinf(next)) continue;
    const Both middle = (Both(value) + Both(next)) * Both(0.5);
    const Both rest = Both(samples.tiny()) * Both(samples.tiny());
    for (const Both& near : {middle, middle + rest, middle - rest})
      expect_rounded(near.reference, Reference(1.0), near.number.nearest());
  }
}

TEST(Dyadic, NearestAtTheEndsOfTheRange) {
  const double largest = std::numeric_limits<double>::max(), infinite = HUGE_VAL;
  const double least = std::numeric_limits<double>::denorm_min();
  const Dyadic half_ulp(0x1p970), one(least), half(0.5);
  EXPECT_EQ((Dyadic(largest) + half_ulp).nearest(), infinite);
  EXPECT_EQ((Dyadic(largest) + half_ulp - one).nearest(), largest);
  EXPECT_EQ((-Dyadic(largest) - half_ulp).nearest(), -infinite);
  EXPECT_EQ((Dyadic(largest) * Dyadic(largest)).nearest(), infinite);
  EXPECT_EQ((one * half).nearest(), 0.0);
  EXPECT_EQ((one * half + one * half * half).nearest(), least);
  EXPECT_EQ((one * half + one * one).nearest(), least);
  EXPECT_EQ((one * half - one * one).nearest(), 0.0);
  EXPECT_EQ((one * Dyadic(1.5)).nearest(), 2 * least);
  EXPECT_EQ((one * one).nearest(), 0.0);
}

TEST(Dyadic, QuotientsAreCorrectlyRounded) {
  NumberSamples samples(8);
  for (int i = 0; i < 20000; ++i) {
    const Both a = polynomial(samples, 1 + i % 3, 1 + i % 4);
    const Both b = polynomial(samples, 1 + i % 2, 1 + i % 3);
    if (b.number.sign() == Sign::zero) continue;
    expect_rounded(a.reference, b.reference, nearest_quotient(a.number, b.number));
  }
}

// Quotients that are doubles, middles between doubles, or next to them, all over the range.
TEST(Dyadic, QuotientsDecideTies) {
  NumberSamples samples(9);
  for (int i = 0; i < 20000; ++i) {
    const double value = samples.any(), next = std::nextafter(value, HUGE_VAL);
    const Both denominator = polynomial(samples, 2, 1 + i % 6);
    if (std::isinf(next) || denominator.number.sign() == Sign::zero) continue;
    const Both exact = Both(value) * denominator;
    EXPECT_EQ(nearest_quotient(exact.number, denominator.number), value);
    const Both middle = (Both(value) + Both(next)) * Both(0.5) * denominator;
    const Both rest = Both(samples.tiny()) * Both(samples.tiny()) * Both(samples.tiny());
    for (const Both& near : {middle, middle + rest, middle - rest})
      expect_rounded(near.reference, denominator.reference,
                     nearest_quotient(near.number, denominator.number));
  }
}

TEST(Dyadic, QuotientsOfIntegersAreThoseOfTheProcessor) {
  NumberSamples samples(10);
  for (int i = 0; i < 100000; ++i) {
    const double a = samples.full(), b = samples.full();
    EXPECT_EQ(nearest_quotient(Dyadic(a), Dyadic(b)), a / b);
    const double down = std::ldexp(a, -1060);
    EXPECT_EQ(nearest_quotient(Dyadic(down), Dyadic(b)), down / b);
    const double up = std::ldexp(a, 1020);
    EXPECT_EQ(nearest_quotient(Dyadic(up), Dyadic(b)), up / b);
  }
}

}  // namespace
}  // namespace sectile::test
