// Doubles as rationals of any length: the slow reference for the exact tests.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "numbers/sign.h"

namespace sectile::test {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

inline Rational rational(double value) {
  int exponent;
  const double fraction = std::frexp(value, &exponent);
  const Integer mantissa(static_cast<long long>(fraction * 0x1p53));
  exponent -= 53;
  return exponent >= 0 ? Rational(mantissa << static_cast<unsigned>(exponent))
                       : Rational(mantissa, Integer(1) << static_cast<unsigned>(-exponent));
}

inline Sign rational_sign(const Rational& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

/// The nearest double, ties to even, by definition.
inline double nearest(const Rational& value) {
  if (value == 0) return 0;
  Integer n = abs(numerator(value)), d = denominator(value);
  long exponent = static_cast<long>(msb(n)) - static_cast<long>(msb(d));
  const auto shifted = [](Integer i, long by) {
    return by > 0 ? Integer(i << static_cast<unsigned>(by)) : i;
  };
  if (shifted(n, -exponent) < shifted(d, exponent)) --exponent;
  const long last = std::max(exponent - 52, -1074L);
  Integer quotient, rest;
  divide_qr(shifted(n, -last), shifted(d, last), quotient, rest);
  rest *= 2;
  const Integer unit = shifted(d, last);
  if (rest > unit || (rest == unit && (quotient & 1) != 0)) ++quotient;
  const double result = std::ldexp(quotient.convert_to<double>(), static_cast<int>(last));
  return value < 0 ? -result : result;
}

/// Doubles of all kinds: small integers, fractions, denormals, and exponents hundreds apart.
class AnyDouble {
 public:
  explicit AnyDouble(unsigned seed) : random_(seed) {}
  double operator()() {
    const double sign = random_() & 1u ? -1 : 1;
    switch (random_() % 6) {
      case 0:
        return sign * static_cast<double>(random_() % 11);
      case 1:
        return sign * std::ldexp(static_cast<double>(random_() >> 11),
                                 static_cast<int>(random_() % 900) - 500);
      case 2:
        return sign * std::ldexp(static_cast<double>(random_() % 100), -1074);
      case 3:
        return sign * static_cast<double>(random_() >> 11) * 0x1p-53;
      case 4:
        return 0;
      default:
        return sign * static_cast<double>(random_() % 2001) / 8;
    }
  }
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_;
};

}  // namespace sectile::test
