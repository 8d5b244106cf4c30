// Exact numbers m · 2^e with integers m of any length: what sums and products of doubles are.
#pragma once

#include <bit>
#include <cassert>
#include <compare>
#include <cstdint>
#include <cstring>
#include <utility>

#include "numbers/sign.h"

namespace sectile {

class Dyadic {
 public:
  Dyadic() { inline_[0] = inline_[1] = 0; }  ///< zero
  explicit Dyadic(double value);             ///< exactly; value must be finite
  Dyadic(const Dyadic& other) { copy(other); }
  Dyadic(Dyadic&& other) noexcept { take(other); }
  Dyadic& operator=(const Dyadic& other);
  Dyadic& operator=(Dyadic&& other) noexcept;
  ~Dyadic() {
    if (on_heap()) delete[] heap_;
  }
  static Dyadic difference(double a, double b) { return Dyadic(a) - Dyadic(b); }

  Sign sign() const {
    return size_ == 0 ? Sign::zero : negative_ ? Sign::negative : Sign::positive;
  }
  double nearest() const;  ///< rounded to nearest, ties to even; infinite on overflow
  /// The power of two that |this| reaches but not the next one; this is not zero.
  std::int64_t magnitude() const { return exponent_ + bit_length() - 1; }
  /// This number times 2^by.
  Dyadic scaled(std::int64_t by) const { return product(*this, Dyadic(false, by, 1)); }

  Dyadic operator-() const {
    Dyadic result(*this);
    result.negative_ = !negative_;
    return result;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.negative_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, !b.negative_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) { return product(a, b); }
  Dyadic& operator+=(const Dyadic& other) { return *this = *this + other; }
  Dyadic& operator-=(const Dyadic& other) { return *this = *this - other; }
  Dyadic& operator*=(const Dyadic& other) { return *this = *this * other; }

  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).size_ == 0; }
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) {
    return static_cast<int>((a - b).sign()) <=> 0;
  }

  friend double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator);

 private:
  using Limb = std::uint64_t;
  __extension__ using Wide = unsigned __int128;
  // Enough for all tests on coordinates of 53 bits with exponents 50 apart. Longer numbers, and
  // only they, are on the heap.
  static constexpr std::uint32_t inline_size = 16;
  // Moved as a whole, without a look at the size.
  static constexpr std::uint32_t copied_size = 4;

  Dyadic(bool negative, std::int64_t exponent, Wide mantissa);

  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool b_negative);
  static Dyadic long_sum(const Dyadic& a, const Dyadic& b, bool b_negative);
  static Dyadic product(const Dyadic& a, const Dyadic& b);
  static Dyadic long_product(const Dyadic& a, const Dyadic& b);

  bool on_heap() const { return size_ > inline_size; }
  const Limb* limbs() const { return on_heap() ? heap_ : inline_; }
  Limb top_limb() const { return limbs()[size_ - 1]; }
  Limb top_64_bits() const;
  bool bits_below_top() const;
  std::int64_t bit_length() const {
    return 64 * std::int64_t(size_) - std::countl_zero(top_limb());
  }
  Wide wide() const { return Wide(inline_[1]) << 64 | inline_[0]; }  // for up to two limbs
  Limb* allot(std::uint32_t size);  // to a number that holds nothing on the heap
  void normalize();
  void copy(const Dyadic& other);
  void take(Dyadic& other);

  // The lowest limb is never zero, nor is the highest, and no shift would save a limb. Behind less
  // than two limbs there are zeros.
  std::int64_t exponent_ = 0;
  std::uint32_t size_ = 0;
  bool negative_ = false;
  union {
    Limb* heap_;
    Limb inline_[inline_size];  // only the first size_ ones mean anything
  };
};

/// numerator / denominator, correctly rounded. The denominator is not zero.
double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator);

/// numerator / denominator, off by at most 2^-bits of the quotient. The denominator is not zero.
Dyadic quotient(const Dyadic& numerator, const Dyadic& denominator, int bits);

/// The root of a number that is not negative, off by at most 2^-100 of the root.
Dyadic square_root(const Dyadic& number);

/// The exact sign of a[0]·b[0] + … + a[count-1]·b[count-1], for finite doubles of any size.
Sign sign_of_dot(const double* a, const double* b, int count);

inline Dyadic::Dyadic(bool negative, std::int64_t exponent, Wide mantissa) : negative_(negative) {
  Limb low = static_cast<Limb>(mantissa), high = static_cast<Limb>(mantissa >> 64);
  if (low == 0) {
    low = high;
    high = 0;
    exponent += 64;
  } else if (high != 0) {
    const int zeros = std::countr_zero(low);
    if (zeros + std::countl_zero(high) >= 64) {
      low = static_cast<Limb>(mantissa >> zeros);
      high = 0;
      exponent += zeros;
    }
  }
  exponent_ = exponent;
  size_ = high != 0 ? 2 : low != 0 ? 1 : 0;
  inline_[0] = low;
  inline_[1] = high;
}

inline Dyadic::Dyadic(double value) : Dyadic() {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto field = static_cast<std::int64_t>(bits >> 52 & 0x7FFu);
  assert(field != 0x7FF);
  Limb mantissa = bits & 0xFFFFFFFFFFFFFu;
  if (field != 0) mantissa |= Limb(1) << 52;
  if (mantissa == 0) return;
  const int zeros = std::countr_zero(mantissa);
  inline_[0] = mantissa >> zeros;
  size_ = 1;
  exponent_ = (field != 0 ? field : 1) - 1075 + zeros;
  negative_ = bits >> 63;
}

inline Dyadic::Limb* Dyadic::allot(std::uint32_t size) {
  if (size > inline_size) heap_ = new Limb[size];
  size_ = size;
  return size > inline_size ? heap_ : inline_;
}

inline void Dyadic::copy(const Dyadic& other) {
  exponent_ = other.exponent_;
  negative_ = other.negative_;
  Limb* const to = allot(other.size_);
  if (size_ <= copied_size)
    std::memcpy(inline_, other.inline_, copied_size * sizeof(Limb));
  else
    std::memcpy(to, other.limbs(), size_ * sizeof(Limb));
}

inline void Dyadic::take(Dyadic& other) {
  exponent_ = other.exponent_;
  negative_ = other.negative_;
  size_ = other.size_;
  if (size_ <= copied_size)
    std::memcpy(inline_, other.inline_, copied_size * sizeof(Limb));
  else if (!on_heap())
    std::memcpy(inline_, other.inline_, size_ * sizeof(Limb));
  else
    heap_ = other.heap_;
  other.size_ = 0;
  other.inline_[0] = other.inline_[1] = 0;
}

inline Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this == &other) return *this;
  if (on_heap() || other.on_heap()) return *this = Dyadic(other);
  copy(other);
  return *this;
}

inline Dyadic& Dyadic::operator=(Dyadic&& other) noexcept {
  if (this == &other) return *this;
  if (on_heap()) delete[] heap_;
  take(other);
  return *this;
}

inline Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool b_negative) {
  if (a.size_ > 2 || b.size_ > 2) return long_sum(a, b, b_negative);
  const std::int64_t shift = a.exponent_ - b.exponent_;
  const bool swap = shift < 0;
  const Wide upper = swap ? b.wide() : a.wide(), lower = swap ? a.wide() : b.wide();
  const std::int64_t up = swap ? -shift : shift, exponent = swap ? a.exponent_ : b.exponent_;
  if (up > 126 || upper >> (127 - up) != 0 || lower >> 127 != 0) return long_sum(a, b, b_negative);
  // Without branches, since signs are hard to foresee.
  const bool opposite = a.negative_ != b_negative, upper_negative = swap ? b_negative : a.negative_;
  const Wide flip = -Wide(opposite), total = (upper << up) + ((lower ^ flip) - flip);
  const bool below = opposite && total >> 127 != 0;
  const Wide flip_back = -Wide(below);
  return Dyadic(upper_negative != below, exponent, (total ^ flip_back) - flip_back);
}

inline Dyadic Dyadic::product(const Dyadic& a, const Dyadic& b) {
  if (a.size_ != 1 || b.size_ != 1) return long_product(a, b);
  return Dyadic(a.negative_ != b.negative_, a.exponent_ + b.exponent_,
                Wide(a.inline_[0]) * b.inline_[0]);
}

}  // namespace sectile
