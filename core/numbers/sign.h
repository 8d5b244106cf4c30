// The outcome of every exact test.
#pragma once

#include <cstdint>

namespace sectile {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) {
  return static_cast<Sign>(-static_cast<int>(s));
}
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
constexpr Sign sign_of(double value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

}  // namespace sectile
