// m · 2^e with integers of boost::multiprecision: sums and products in the plainest way.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "numbers/sign.h"

namespace sectile::test {

using boost::multiprecision::cpp_int;

struct Reference {
  cpp_int mantissa = 0;
  int exponent = 0;

  Reference() = default;
  explicit Reference(double value) {
    const double fraction = std::frexp(value, &exponent);
    mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponent -= 53;
  }
  Reference(cpp_int m, int e) : mantissa(std::move(m)), exponent(e) {}

  Sign sign() const { return static_cast<Sign>(mantissa.sign()); }
  Reference operator-() const { return {-mantissa, exponent}; }
  friend Reference operator*(const Reference& a, const Reference& b) {
    return {a.mantissa * b.mantissa, a.exponent + b.exponent};
  }
  friend Reference operator+(const Reference& a, const Reference& b) {
    if (a.mantissa == 0) return b;
    if (b.mantissa == 0) return a;
    const int least = std::min(a.exponent, b.exponent);
    return {(a.mantissa << (a.exponent - least)) + (b.mantissa << (b.exponent - least)), least};
  }
  friend Reference operator-(const Reference& a, const Reference& b) { return a + -b; }
  friend bool operator==(const Reference& a, const Reference& b) {
    return (a - b).sign() == Sign::zero;
  }
};

}  // namespace sectile::test
