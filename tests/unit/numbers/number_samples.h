// Random doubles of all kinds.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace sectile::test {

class NumberSamples {
 public:
  explicit NumberSamples(std::uint64_t seed) : random_(seed) {}

  bool chance(int of) { return random_() % static_cast<unsigned>(of) == 0; }
  /// An integer up to the limit, as often negative as positive.
  double integer(std::int64_t limit) {
    return static_cast<double>(static_cast<std::int64_t>(random_() % (2 * limit + 1)) - limit);
  }
  /// 53 bits, between 1 and 2 in size.
  double full() {
    return signed_value(1.0 + std::ldexp(static_cast<double>(random_() >> 12), -52));
  }
  /// Below all normal doubles.
  double denormal() {
    return signed_value(std::bit_cast<double>(random_() >> 12 >> random_() % 52));
  }
  double power_of_two() { return signed_value(std::ldexp(1.0, exponent(1000))); }
  /// Near to the least doubles, never zero.
  double tiny() { return chance(2) ? signed_value(0x1p-1074) : std::ldexp(full(), -1030); }

  double any() {
    switch (random_() % 9) {
      case 0:
        return integer(10);
      case 1:
        return integer(std::int64_t(1) << 53);
      case 2:
        return std::ldexp(integer(1 << 20), exponent(40));
      case 3:
        return full();
      case 4:
        return std::ldexp(full(), exponent(60));
      case 5:
        return std::ldexp(full(), exponent(1020));
      case 6:
        return denormal();
      case 7:
        return power_of_two();
      default:
        return signed_value(std::ldexp(1.0 - 0x1p-53, exponent(1000)));
    }
  }
  /// Equal, next to it, of like size, or anything.
  double near(double value) {
    switch (random_() % 4) {
      case 0:
        return value;
      case 1:
        return std::nextafter(value, 0.0);
      case 2:
        return std::ldexp(full(), value == 0 ? 0 : std::min(std::ilogb(value), 1022));
      default:
        return any();
    }
  }

 private:
  double signed_value(double size) { return chance(2) ? -size : size; }
  int exponent(int limit) {
    return static_cast<int>(random_() % static_cast<unsigned>(2 * limit + 1)) - limit;
  }

  std::mt19937_64 random_;
};

}  // namespace sectile::test
