#include "numbers/dyadic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sectile {
namespace {

__extension__ using Wide = unsigned __int128;
using Limb = std::uint64_t;

// to = from · 2^shift in exactly `size` limbs, which must suffice.
void copy_shifted(Limb* to, std::uint32_t size, const Limb* from, std::uint32_t from_size,
                  std::uint64_t shift) {
  const auto whole = static_cast<std::uint32_t>(shift / 64);
  const unsigned part = shift % 64;
  std::uint32_t at = 0;
  while (at < whole) to[at++] = 0;
  if (part == 0) {
    for (std::uint32_t i = 0; i < from_size; ++i) to[at++] = from[i];
  } else {
    Limb carry = 0;
    for (std::uint32_t i = 0; i < from_size; ++i) {
      to[at++] = from[i] << part | carry;
      carry = from[i] >> (64 - part);
    }
    if (at < size) to[at++] = carry;
  }
  while (at < size) to[at++] = 0;
}

// a += b, for a that has room for the carry.
void add(Limb* a, const Limb* b, std::uint32_t b_size) {
  Limb carry = 0;
  std::uint32_t i = 0;
  for (; i < b_size; ++i) {
    const Wide s = Wide(a[i]) + b[i] + carry;
    a[i] = static_cast<Limb>(s);
    carry = static_cast<Limb>(s >> 64);
  }
  for (; carry != 0; ++i) carry = ++a[i] == 0;
}

// a -= b, for a >= b.
void subtract(Limb* a, const Limb* b, std::uint32_t b_size) {
  Limb borrow = 0;
  std::uint32_t i = 0;
  for (; i < b_size; ++i) {
    const Wide d = Wide(a[i]) - b[i] - borrow;
    a[i] = static_cast<Limb>(d);
    borrow = static_cast<Limb>(d >> 64) & 1u;
  }
  for (; borrow != 0; ++i) borrow = a[i]-- == 0;
}

// a = b - a, for b > a: both have the same size but for zeros.
void subtract_from(Limb* a, const Limb* b, std::uint32_t b_size) {
  Limb borrow = 0;
  for (std::uint32_t i = 0; i < b_size; ++i) {
    const Wide d = Wide(b[i]) - a[i] - borrow;
    a[i] = static_cast<Limb>(d);
    borrow = static_cast<Limb>(d >> 64) & 1u;
  }
}

// a < b, where a may have zeros on top.
bool less(const Limb* a, std::uint32_t a_size, const Limb* b, std::uint32_t b_size) {
  while (a_size > b_size)
    if (a[--a_size] != 0) return false;
  for (std::uint32_t i = b_size; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i];
  return false;
}

void multiply(Limb* to, const Limb* a, std::uint32_t a_size, const Limb* b, std::uint32_t b_size) {
  Limb carry = 0;
  for (std::uint32_t j = 0; j < b_size; ++j) {
    const Wide s = Wide(a[0]) * b[j] + carry;
    to[j] = static_cast<Limb>(s);
    carry = static_cast<Limb>(s >> 64);
  }
  to[b_size] = carry;
  for (std::uint32_t i = 1; i < a_size; ++i) {
    carry = 0;
    for (std::uint32_t j = 0; j < b_size; ++j) {
      const Wide s = Wide(a[i]) * b[j] + to[i + j] + carry;
      to[i + j] = static_cast<Limb>(s);
      carry = static_cast<Limb>(s >> 64);
    }
    to[i + b_size] = carry;
  }
}

// mantissa · 2^exponent for a mantissa up to 2^53, and below 2^52 only with the least exponent.
double assemble(bool negative, std::int64_t exponent, Limb mantissa) {
  if (exponent > 971) {
    mantissa = Limb(0x7FF) << 52;
  } else {
    mantissa += static_cast<Limb>(exponent + 1074) << 52;
  }
  return std::bit_cast<double>(mantissa | Limb(negative) << 63);
}

constexpr std::int64_t least_exponent = -1074;

}  // namespace

void Dyadic::normalize() {
  Limb* const from = on_heap() ? heap_ : inline_;
  const bool was_on_heap = on_heap();
  std::uint32_t end = size_, begin = 0;
  while (end > 0 && from[end - 1] == 0) --end;
  while (begin < end && from[begin] == 0) ++begin;
  size_ = end - begin;
  exponent_ += 64 * std::int64_t(begin);
  if (size_ > 1) {
    const int zeros = std::countr_zero(from[begin]);
    if (zeros + std::countl_zero(from[end - 1]) >= 64) {
      for (std::uint32_t i = begin; i + 1 < end; ++i)
        from[i] = from[i] >> zeros | from[i + 1] << (64 - zeros);
      exponent_ += zeros;
      --size_;
    }
  }
  if (was_on_heap && !on_heap()) {
    std::memcpy(inline_, from + begin, size_ * sizeof(Limb));
    delete[] from;
  } else if (begin > 0) {
    std::memmove(from, from + begin, size_ * sizeof(Limb));
  }
  for (std::uint32_t i = size_; i < 2; ++i) inline_[i] = 0;
}

Dyadic Dyadic::long_sum(const Dyadic& a, const Dyadic& b, bool b_negative) {
  if (b.size_ == 0) return a;
  if (a.size_ == 0) {
    Dyadic result(b);
    result.negative_ = b_negative;
    return result;
  }
  const bool a_is_upper = a.exponent_ >= b.exponent_;
  const Dyadic &upper = a_is_upper ? a : b, &lower = a_is_upper ? b : a;
  const bool upper_negative = a_is_upper ? a.negative_ : b_negative,
             lower_negative = a_is_upper ? b_negative : a.negative_;
  const std::int64_t shift = upper.exponent_ - lower.exponent_;
  const std::int64_t bits = std::max(upper.bit_length() + shift, lower.bit_length()) + 1;
  Dyadic result;
  result.exponent_ = lower.exponent_;
  result.negative_ = upper_negative;
  const auto size = static_cast<std::uint32_t>((bits + 63) / 64);
  Limb* const to = result.allot(size);
  copy_shifted(to, size, upper.limbs(), upper.size_, static_cast<std::uint64_t>(shift));
  const Limb* const other = lower.limbs();
  if (upper_negative == lower_negative) {
    add(to, other, lower.size_);
  } else if (less(to, size, other, lower.size_)) {
    subtract_from(to, other, lower.size_);
    result.negative_ = lower_negative;
  } else {
    subtract(to, other, lower.size_);
  }
  result.normalize();
  return result;
}

Dyadic Dyadic::long_product(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  const std::uint32_t size = a.size_ + b.size_;
  Limb* const to = result.allot(size);
  const Dyadic &longer = a.size_ < b.size_ ? b : a, &shorter = a.size_ < b.size_ ? a : b;
  multiply(to, shorter.limbs(), shorter.size_, longer.limbs(), longer.size_);
  result.exponent_ = a.exponent_ + b.exponent_;
  result.negative_ = a.negative_ != b.negative_;
  result.normalize();
  return result;
}

// The highest 64 bits, filled up with zeros on the right.
Dyadic::Limb Dyadic::top_64_bits() const {
  const Limb* const from = limbs();
  const Limb top = from[size_ - 1];
  const int zeros = std::countl_zero(top);
  if (zeros == 0) return top;
  return top << zeros | (size_ > 1 ? from[size_ - 2] >> (64 - zeros) : 0);
}

bool Dyadic::bits_below_top() const {
  if (size_ == 2) return limbs()[0] << std::countl_zero(top_limb()) != 0;
  return size_ > 2;  // the lowest limb is not zero
}

double Dyadic::nearest() const {
  if (size_ == 0) return 0;
  const Limb top = top_64_bits();
  const std::int64_t exponent = exponent_ + bit_length() - 64;
  const std::int64_t last = std::max(exponent + 11, least_exponent);
  const std::int64_t drop = last - exponent;
  if (drop > 64) return assemble(negative_, least_exponent, 0);
  const Limb kept = drop == 64 ? 0 : top >> drop;
  const Limb rest = top << (64 - drop), half = Limb(1) << 63;
  bool up = rest > half;
  if (rest == half) up = (kept & 1u) != 0 || bits_below_top();
  return assemble(negative_, last, kept + up);
}

// Bounds from the highest 64 bits of both decide, unless the quotient lies within two units of the
// 64th bit from the middle between two doubles.
double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator) {
  if (numerator.size_ == 0) return 0;
  const bool negative = numerator.negative_ != denominator.negative_;
  const Limb n = numerator.top_64_bits(), d = denominator.top_64_bits();
  // n / d is above 1/2 and below 2. The true quotient lies within quotient ± 2.
  const auto quotient = static_cast<Limb>((Wide(n) << 63) / d);
  const std::int64_t exponent = numerator.exponent_ + numerator.bit_length() -
                                denominator.exponent_ - denominator.bit_length() - 63;
  const std::int64_t last = std::max(exponent + 11 - std::countl_zero(quotient), least_exponent);
  const std::int64_t drop = last - exponent;
  if (drop > 65) return assemble(negative, least_exponent, 0);
  const Limb kept = drop > 63 ? 0 : quotient >> drop;
  const Wide middle = Wide(2 * kept + 1) << (drop - 1);
  bool up = quotient >= middle;
  if (quotient + Wide(2) > middle && quotient < middle + 2) {
    const Dyadic exact_middle(false, last - 1, Wide(2 * kept + 1));
    const Dyadic product = exact_middle * denominator;
    const Sign above =
        Dyadic::sum(numerator, product, !numerator.negative_).sign() * numerator.sign();
    up = above == Sign::positive || (above == Sign::zero && (kept & 1u) != 0);
  }
  return assemble(negative, last, kept + up);
}

// Digit by digit; a digit is a double, the nearest one to what is left, and leaves 2^-52 of it.
Dyadic quotient(const Dyadic& numerator, const Dyadic& denominator, int bits) {
  Dyadic sum, rest = numerator;
  for (int known = 0; known < bits && rest.sign() != Sign::zero; known += 52) {
    const std::int64_t shift = rest.magnitude() - denominator.magnitude();
    const Dyadic digit = Dyadic(nearest_quotient(rest.scaled(-shift), denominator)).scaled(shift);
    sum += digit;
    rest -= digit * denominator;
  }
  return sum;
}

// For the number m · 2^2e with m from 1 to 4, and the double s nearest to the root of m, the root
// of m is s + (m - s²) / 2s, less a number below 2^-104.
Dyadic square_root(const Dyadic& number) {
  if (number.sign() == Sign::zero) return {};
  const std::int64_t e = number.magnitude() >> 1;
  const Dyadic m = number.scaled(-2 * e);
  const Dyadic s(std::sqrt(m.nearest()));
  const Dyadic half(nearest_quotient(m - s * s, s + s));
  return (s + half).scaled(e);
}

}  // namespace sectile
