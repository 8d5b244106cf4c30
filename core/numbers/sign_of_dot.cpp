#include <algorithm>
#include <cmath>

#include "numbers/dyadic.h"

namespace sectile {
namespace {

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
using Limb = std::uint64_t;

constexpr int most_terms = 16;

// Integers below 2^53 in size: their products are summed as such.
bool integers(const double* a, const double* b, int count, SignedWide& total) {
  constexpr double limit = 0x1p53;
  total = 0;
  for (int i = 0; i < count; ++i) {
    if (!(std::abs(a[i]) < limit && std::abs(b[i]) < limit)) return false;
    const auto x = static_cast<std::int64_t>(a[i]), y = static_cast<std::int64_t>(b[i]);
    if (static_cast<double>(x) != a[i] || static_cast<double>(y) != b[i]) return false;
    total += static_cast<SignedWide>(x) * y;
  }
  return true;
}

struct Double {
  explicit Double(double value) : bits(std::bit_cast<std::uint64_t>(value)) {}
  int field() const { return static_cast<int>(bits >> 52 & 0x7FFu); }
  // In units of 2^(exponent() - 1075).
  Limb mantissa() const { return (bits & 0xFFFFFFFFFFFFFu) | Limb(field() != 0) << 52; }
  int exponent() const { return field() + (field() == 0); }

  std::uint64_t bits;
};

// The products as integers in one unit, the positive and the negative ones summed apart.
class Sums {
 public:
  // A product has 106 bits at most; 16 of them, shifted so far, stay below 2^256.
  static constexpr int most_shift = 145;

  void add(Wide product, int shift, bool negative) {
    Limb* const to = sums_[negative] + shift / 64;
    const int part = shift % 64;
    const Limb low = static_cast<Limb>(product), high = static_cast<Limb>(product >> 64);
    // In two steps, because a shift by 64 is not defined.
    const Limb middle = high << part | low >> 1 >> (63 - part), top = high >> 1 >> (63 - part);
    Wide sum = Wide(to[0]) + (low << part);
    to[0] = static_cast<Limb>(sum);
    sum = Wide(to[1]) + middle + static_cast<Limb>(sum >> 64);
    to[1] = static_cast<Limb>(sum);
    sum = Wide(to[2]) + top + static_cast<Limb>(sum >> 64);
    to[2] = static_cast<Limb>(sum);
    to[3] += static_cast<Limb>(sum >> 64);
  }
  Sign sign() const {
    for (int i = size; i-- > 0;)
      if (sums_[0][i] != sums_[1][i])
        return sums_[0][i] > sums_[1][i] ? Sign::positive : Sign::negative;
    return Sign::zero;
  }

 private:
  static constexpr int size = most_shift / 64 + 4;
  Limb sums_[2][size] = {};
};

bool common_unit(const double* a, const double* b, int count, Sign& sign) {
  Wide products[most_terms];
  int exponents[most_terms];
  bool negative[most_terms];
  int terms = 0, least = 4096, most = 0;
  for (int i = 0; i < count; ++i) {
    const Double x(a[i]), y(b[i]);
    const Wide product = Wide(x.mantissa()) * y.mantissa();
    if (product == 0) continue;
    const int exponent = x.exponent() + y.exponent();
    products[terms] = product;
    exponents[terms] = exponent;
    negative[terms] = (x.bits ^ y.bits) >> 63;
    ++terms;
    least = std::min(least, exponent);
    most = std::max(most, exponent);
  }
  if (most - least > Sums::most_shift) return false;
  Sums sums;
  for (int i = 0; i < terms; ++i) sums.add(products[i], exponents[i] - least, negative[i]);
  sign = sums.sign();
  return true;
}

}  // namespace

Sign sign_of_dot(const double* a, const double* b, int count) {
  if (count <= most_terms) {
    SignedWide total;
    if (integers(a, b, count, total))
      return total > 0 ? Sign::positive : total < 0 ? Sign::negative : Sign::zero;
    Sign sign;
    if (common_unit(a, b, count, sign)) return sign;
  }
  Dyadic sum;
  for (int i = 0; i < count; ++i) sum += Dyadic(a[i]) * Dyadic(b[i]);
  return sum.sign();
}

}  // namespace sectile
