// Exact numbers m · 2^e with integers m of any length: what sums and products of doubles are.
#pragma once

#include <cstdint>
#include <memory>

#include "numbers/sign.h"

namespace sectile {

class Dyadic {
 public:
  Dyadic() = default;             ///< zero
  explicit Dyadic(double value);  ///< exactly; value must be finite
  Dyadic(const Dyadic& other) { *this = other; }
  Dyadic(Dyadic&& other) noexcept { *this = std::move(other); }
  Dyadic& operator=(const Dyadic& other);
  Dyadic& operator=(Dyadic&& other) noexcept;
  ~Dyadic() = default;

  Sign sign() const {
    return size_ == 0 ? Sign::zero : negative_ ? Sign::negative : Sign::positive;
  }
  double nearest() const;  ///< rounded to nearest, ties to even; infinite on overflow

  Dyadic operator-() const {
    Dyadic result(*this);
    result.negative_ = !negative_;
    return result;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.negative_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, !b.negative_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator);

 private:
  using Limb = std::uint64_t;
  // Enough for all tests on coordinates of 53 bits and like exponents.
  static constexpr std::uint32_t inline_size = 10;

  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool b_negative);
  Limb* reserve(std::uint32_t size);  // old limbs are lost
  const Limb* limbs() const { return heap_ ? heap_.get() : inline_; }
  Limb* limbs() { return heap_ ? heap_.get() : inline_; }
  void trim();
  std::int64_t bit_length() const;
  /// The limbs times 2^shift (shift >= 0), in exactly `size` limbs.
  void copy_shifted(Limb* to, std::uint32_t size, std::uint64_t shift) const;

  bool negative_ = false;
  std::uint32_t size_ = 0, capacity_ = inline_size;
  std::int64_t exponent_ = 0;
  std::unique_ptr<Limb[]> heap_;
  Limb inline_[inline_size];  // only the first size_ ones mean anything
};

/// numerator / denominator, correctly rounded. The denominator is not zero.
double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator);

/// The exact sign of a[0]·b[0] + … + a[count-1]·b[count-1], for finite doubles of any size.
Sign sign_of_dot(const double* a, const double* b, int count);

}  // namespace sectile
