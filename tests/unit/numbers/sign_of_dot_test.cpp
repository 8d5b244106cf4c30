// Signs of sums of products against integers of boost::multiprecision.
#include "numbers/dyadic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "number_samples.h"
#include "reference_number.h"

namespace sectile::test {
namespace {

Sign reference_dot(const std::vector<double>& a, const std::vector<double>& b) {
  Reference sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + Reference(a[i]) * Reference(b[i]);
  return sum.sign();
}

void expect_dot(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(sign_of_dot(a.data(), b.data(), static_cast<int>(a.size())), reference_dot(a, b));
}

TEST(SignOfDot, NoTerms) {
  EXPECT_EQ(sign_of_dot(nullptr, nullptr, 0), Sign::zero);
}

TEST(SignOfDot, DoublesOfAllKinds) {
  NumberSamples samples(11);
  for (int i = 0; i < 40000; ++i) {
    std::vector<double> a, b;
    for (int j = 0; j < i % 20; ++j) {
      a.push_back(samples.any());
      b.push_back(samples.any());
    }
    expect_dot(a, b);
  }
}

// Pairs of products that cancel, at scales far apart, with and without a small rest.
TEST(SignOfDot, Cancellation) {
  NumberSamples samples(12);
  for (int i = 0; i < 40000; ++i) {
    std::vector<double> a, b;
    for (int j = 0; j < 1 + i % 3; ++j) {
      const double x = samples.any(), y = samples.any();
      a.insert(a.end(), {x, y});
      b.insert(b.end(), {y, -x});
    }
    expect_dot(a, b);
    EXPECT_EQ(reference_dot(a, b), Sign::zero);
    a.push_back(samples.chance(2) ? samples.tiny() : samples.any());
    b.push_back(samples.any());
    expect_dot(a, b);
    a[0] = std::nextafter(a[0], 0.0);
    expect_dot(a, b);
  }
}

TEST(SignOfDot, PlanesThroughGridPoints) {
  NumberSamples samples(13);
  for (const double unit : {1.0, 0x1p-12, 0x1p-40, 0x1p200}) {
    for (int i = 0; i < 5000; ++i) {
      std::vector<double> n(4, 0.0), p(4, 1.0);
      for (int k = 0; k < 3; ++k) {
        n[k] = samples.integer(1000000);
        p[k] = unit * samples.integer(1000000);
        n[3] -= n[k] * p[k];  // no error
      }
      EXPECT_EQ(sign_of_dot(n.data(), p.data(), 4), Sign::zero);
      n[3] += unit;
      EXPECT_EQ(sign_of_dot(n.data(), p.data(), 4), Sign::positive);
      n[3] -= 2 * unit;
      EXPECT_EQ(sign_of_dot(n.data(), p.data(), 4), Sign::negative);
    }
  }
}

TEST(SignOfDot, LargestSums) {
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min(), integer = 0x1p53 - 1;
  for (const double x : {largest, integer, 0x1p53, least}) {
    for (int count = 1; count < 20; ++count) {
      std::vector<double> a(count, x), b(count, x);
      EXPECT_EQ(sign_of_dot(a.data(), b.data(), count), Sign::positive);
      a.insert(a.end(), count, -x);
      b.insert(b.end(), count, x);
      EXPECT_EQ(sign_of_dot(a.data(), b.data(), 2 * count), Sign::zero);
      a[0] = std::nextafter(x, 0.0);
      EXPECT_EQ(sign_of_dot(a.data(), b.data(), 2 * count), Sign::negative);
    }
  }
}

// Exponents so far apart that the shift in a common unit is at and beyond its limit.
TEST(SignOfDot, SpreadOfExponents) {
  for (int spread = 0; spread < 2090; ++spread) {
    const double high = std::ldexp(1.0 + 0x1p-52, std::min(spread, 1000));
    const double low = std::ldexp(2.0 - 0x1p-52, std::min(1000 - spread, 0));
    std::vector<double> a{high, high, low, -high, -high}, b{high, low, low, high, low};
    EXPECT_EQ(sign_of_dot(a.data(), b.data(), 5), low == 0 ? Sign::zero : Sign::positive);
    std::vector<double> c(15, high), d(15, high);
    c.push_back(-low);
    d.push_back(low);
    expect_dot(c, d);
  }
}

}  // namespace
}  // namespace sectile::test
