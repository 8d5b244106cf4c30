#include "numbers/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace sectile {
namespace {

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
using Limb = std::uint64_t;

// a - b for a >= b, in place.
void subtract(Limb* a, std::uint32_t size, const Limb* b) {
  Limb borrow = 0;
  for (std::uint32_t i = 0; i < size; ++i) {
    const Limb difference = a[i] - b[i], result = difference - borrow;
    borrow = (a[i] < b[i]) | (difference < borrow);
    a[i] = result;
  }
}

int compare(const Limb* a, const Limb* b, std::uint32_t size) {
  for (std::uint32_t i = size; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

// Rounds mantissa · 2^exponent, with mantissa of at least 55 bits of which the lowest stands for
// all that follow, to nearest.
double rounded(Limb mantissa, std::int64_t exponent, bool negative) {
  const int bits = 64 - std::countl_zero(mantissa);
  // The last place that a double of this size has.
  const std::int64_t last = std::max<std::int64_t>(exponent + bits - 53, -1074);
  const std::int64_t drop = last - exponent;
  double result;
  if (drop > 64) {
    result = 0;
  } else if (drop == 64) {
    result = mantissa > (Limb(1) << 63) ? std::ldexp(1.0, static_cast<int>(last)) : 0.0;
  } else {
    const Limb half = Limb(1) << (drop - 1), low = mantissa & (2 * half - 1);
    Limb kept = mantissa >> drop;
    if (low > half || (low == half && (kept & 1u))) ++kept;
    result = last > 1100 ? std::numeric_limits<double>::infinity()
                         : std::ldexp(static_cast<double>(kept), static_cast<int>(last));
  }
  return negative ? -result : result;
}

}  // namespace

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  int exponent;
  const double fraction = std::frexp(std::abs(value), &exponent);
  const auto mantissa = static_cast<Limb>(fraction * 0x1p53);
  const int zeros = std::countr_zero(mantissa);
  inline_[0] = mantissa >> zeros;
  size_ = 1;
  exponent_ = exponent - 53 + zeros;
  negative_ = value < 0;
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this == &other) return *this;
  std::memcpy(reserve(other.size_), other.limbs(), other.size_ * sizeof(Limb));
  size_ = other.size_;
  negative_ = other.negative_;
  exponent_ = other.exponent_;
  return *this;
}

Dyadic& Dyadic::operator=(Dyadic&& other) noexcept {
  if (!other.heap_) return *this = static_cast<const Dyadic&>(other);
  heap_ = std::move(other.heap_);
  capacity_ = other.capacity_;
  size_ = other.size_;
  negative_ = other.negative_;
  exponent_ = other.exponent_;
  other.capacity_ = inline_size;
  other.size_ = 0;
  return *this;
}

Dyadic::Limb* Dyadic::reserve(std::uint32_t size) {
  if (size > capacity_) {
    heap_ = std::make_unique_for_overwrite<Limb[]>(size);
    capacity_ = size;
  }
  return limbs();
}

void Dyadic::trim() {
  Limb* l = limbs();
  while (size_ > 0 && l[size_ - 1] == 0) --size_;
  std::uint32_t zeros = 0;
  while (zeros < size_ && l[zeros] == 0) ++zeros;
  if (zeros > 0) {
    std::memmove(l, l + zeros, (size_ - zeros) * sizeof(Limb));
    size_ -= zeros;
    exponent_ += 64 * std::int64_t(zeros);
  }
  if (size_ == 0) exponent_ = 0;
}

std::int64_t Dyadic::bit_length() const {
  return 64 * std::int64_t(size_) - std::countl_zero(limbs()[size_ - 1]);
}

void Dyadic::copy_shifted(Limb* to, std::uint32_t size, std::uint64_t shift) const {
  const auto whole = static_cast<std::uint32_t>(shift / 64);
  const unsigned part = shift % 64;
  const Limb* from = limbs();
  std::fill_n(to, std::min(whole, size), Limb(0));
  Limb carry = 0;
  std::uint32_t at = whole;
  for (std::uint32_t i = 0; i < size_ && at < size; ++i, ++at) {
    to[at] = part ? (from[i] << part) | carry : from[i];
    carry = part ? from[i] >> (64 - part) : 0;
  }
  if (at < size) to[at++] = carry;
  std::fill(to + std::min(at, size), to + size, Limb(0));
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool b_negative) {
  if (b.size_ == 0) return a;
  if (a.size_ == 0) {
    Dyadic result(b);
    result.negative_ = b_negative;
    return result;
  }
  Dyadic result;
  result.exponent_ = std::min(a.exponent_, b.exponent_);
  const auto shift_a = static_cast<std::uint64_t>(a.exponent_ - result.exponent_);
  const auto shift_b = static_cast<std::uint64_t>(b.exponent_ - result.exponent_);
  const std::uint64_t bits =
      std::max(shift_a + 64 * std::uint64_t(a.size_), shift_b + 64 * std::uint64_t(b.size_));
  const auto size = static_cast<std::uint32_t>(bits / 64 + 2);
  Limb* to = result.reserve(size);
  a.copy_shifted(to, size, shift_a);
  Limb small[2 * inline_size];
  std::unique_ptr<Limb[]> large;
  Limb* other = small;
  if (size > 2 * inline_size) {
    large = std::make_unique_for_overwrite<Limb[]>(size);
    other = large.get();
  }
  b.copy_shifted(other, size, shift_b);
  result.size_ = size;
  result.negative_ = a.negative_;
  if (a.negative_ == b_negative) {
    Limb carry = 0;
    for (std::uint32_t i = 0; i < size; ++i) {
      const Wide s = Wide(to[i]) + other[i] + carry;
      to[i] = static_cast<Limb>(s);
      carry = static_cast<Limb>(s >> 64);
    }
  } else if (compare(to, other, size) >= 0) {
    subtract(to, size, other);
  } else {
    subtract(other, size, to);
    std::memcpy(to, other, size * sizeof(Limb));
    result.negative_ = b_negative;
  }
  result.trim();
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  const std::uint32_t size = a.size_ + b.size_;
  Limb* to = result.reserve(size);
  const Limb *p = a.limbs(), *q = b.limbs();
  if (size == 2) {
    const Wide product = Wide(p[0]) * q[0];
    to[0] = static_cast<Limb>(product);
    to[1] = static_cast<Limb>(product >> 64);
  } else {
    std::fill_n(to, size, Limb(0));
    for (std::uint32_t i = 0; i < a.size_; ++i) {
      Limb carry = 0;
      for (std::uint32_t j = 0; j < b.size_; ++j) {
        const Wide s = Wide(p[i]) * q[j] + to[i + j] + carry;
        to[i + j] = static_cast<Limb>(s);
        carry = static_cast<Limb>(s >> 64);
      }
      to[i + b.size_] = carry;
    }
  }
  result.size_ = size;
  result.exponent_ = a.exponent_ + b.exponent_;
  result.negative_ = a.negative_ != b.negative_;
  result.trim();
  return result;
}

double Dyadic::nearest() const {
  return nearest_quotient(*this, Dyadic(1.0));
}

double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator) {
  if (numerator.size_ == 0) return 0;
  // Shift so that the integer quotient has 62 or 63 bits, then divide long hand, bit by bit of the
  // quotient; the remainder only matters by being zero or not.
  const std::int64_t shift = 62 - (numerator.bit_length() - denominator.bit_length());
  const std::uint64_t up_n = shift > 0 ? static_cast<std::uint64_t>(shift) : 0;
  const std::uint64_t up_d = shift < 0 ? static_cast<std::uint64_t>(-shift) : 0;
  const std::uint64_t bits = std::max(up_n + 64 * std::uint64_t(numerator.size_),
                                      up_d + 64 * std::uint64_t(denominator.size_) + 64);
  const auto size = static_cast<std::uint32_t>(bits / 64 + 2);
  std::vector<Limb> rest(size), divisor(size);
  numerator.copy_shifted(rest.data(), size, up_n);
  denominator.copy_shifted(divisor.data(), size, up_d + 63);
  Limb quotient = 0;
  for (int bit = 63; bit >= 0; --bit) {
    if (compare(rest.data(), divisor.data(), size) >= 0) {
      subtract(rest.data(), size, divisor.data());
      quotient |= Limb(1) << bit;
    }
    for (std::uint32_t i = 0; i + 1 < size; ++i)
      divisor[i] = divisor[i] >> 1 | divisor[i + 1] << 63;
    divisor[size - 1] >>= 1;
  }
  if (std::any_of(rest.begin(), rest.end(), [](Limb l) { return l != 0; })) quotient |= 1u;
  return rounded(quotient, numerator.exponent_ - denominator.exponent_ - shift,
                 numerator.negative_ != denominator.negative_);
}

Sign sign_of_dot(const double* a, const double* b, int count) {
  // Products that are integers below 2^106 after scaling by their common exponent are summed in 128
  // bits.
  SignedWide total = 0;
  bool fits = count <= 8;
  for (int i = 0; fits && i < count; ++i) {
    constexpr double limit = 0x1p53;
    fits = std::abs(a[i]) < limit && std::abs(b[i]) < limit && a[i] == std::trunc(a[i]) &&
           b[i] == std::trunc(b[i]);
    if (fits)
      total += SignedWide(static_cast<std::int64_t>(a[i])) * static_cast<std::int64_t>(b[i]);
  }
  if (fits) return total > 0 ? Sign::positive : total < 0 ? Sign::negative : Sign::zero;
  Dyadic sum;
  for (int i = 0; i < count; ++i) sum = sum + Dyadic(a[i]) * Dyadic(b[i]);
  return sum.sign();
}

}  // namespace sectile
