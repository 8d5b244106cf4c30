// Numbers known to about 104 bits, with a bound of their error: the step between doubles and exact
// numbers. Sums and products follow Dekker (1971) and Knuth (TAOCP 2, 4.2.2): the rounding error of
// a sum or product of two doubles is a double itself.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "numbers/rounding.h"
#include "numbers/sign.h"

namespace sectile {

/// A number rounded to nearest.
struct Rounded {
  double value;
  bool inexact;  ///< certainly not the number itself
};

/// Stands for the numbers from high + low - error to high + low + error. What overflows becomes NaN
/// or has no finite error; it decides nothing.
class Bounded {
 public:
  Bounded() = default;
  explicit Bounded(double value) : high_(value) {}

  /// a - b without error.
  static Bounded difference(double a, double b) {
    Bounded result;
    result.high_ = a - b;
    result.low_ = sum_error(a, -b, result.high_);
    return result;
  }

  /// The numbers from value - error to value + error.
  static Bounded within(double value, double error) { return Bounded(value, 0, error); }

  double high() const { return high_; }  ///< half an ulp from high + low at most
  double low() const { return low_; }
  double error() const { return error_; }

  bool decided() const { return std::abs(high_) > error_ * (1 + 4 * unit) + std::abs(low_); }
  Sign sign() const { return sign_of(high_); }  ///< if it is decided

  Bounded operator-() const { return Bounded(-high_, -low_, error_); }

  // u stands for the unit roundoff. The errors e of high + high, and low + low, are below u|high|
  // each; so are, with another u, those of the three sums of such numbers: 5 u² (|a| + |b|) in all.
  // Sums do not underflow, and errors are multiples of the least double: the bound holds there too.
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double high = a.high_ + b.high_;
    const double low = sum_error(a.high_, b.high_, high) + (a.low_ + b.low_);
    const double error = 8 * unit * unit * (std::abs(a.high_) + std::abs(b.high_));
    return normal(high, low, (a.error_ + b.error_ + error) * (1 + 8 * unit));
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }

  // low · low is left out; with the roundings of the other terms that makes 8 u² |a b|. Each of the
  // roundings may also be one of underflow.
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double high = a.high_ * b.high_;
    const double low = std::fma(a.high_, b.high_, -high) + (a.high_ * b.low_ + a.low_ * b.high_);
    const double size_a = std::abs(a.high_), size_b = std::abs(b.high_);
    const double error = size_a * b.error_ + a.error_ * size_b + a.error_ * b.error_ +
                         16 * unit * unit * std::abs(high) + 16 * underflow;
    return normal(high, low, error * (1 + 16 * unit));
  }

  /// numerator / denominator, with an endless error if the denominator may be zero.
  friend Bounded quotient(const Bounded& numerator, const Bounded& denominator) {
    if (numerator.is_zero()) return {};
    const double first = numerator.high_ / denominator.high_;
    const Bounded rest = numerator - Bounded(first) * denominator;
    const double second = rest.high_ / denominator.high_;
    const double doubt = std::abs(denominator.low_) + denominator.error_;
    const double size = std::abs(denominator.high_);
    // Then the true denominator is at least half as large as `high`.
    if (!(doubt < size / 4)) return within(first, std::numeric_limits<double>::infinity());
    // Divided before it is multiplied, so that underflow cannot hide the doubt.
    const double error =
        (2 * (std::abs(rest.low_) + rest.error_) / size + 2 * std::abs(second) * (doubt / size) +
         8 * unit * std::abs(second) + 16 * underflow) *
        (1 + 16 * unit);
    return normal(first, second, error);
  }

  /// Correctly rounded, if the error leaves no doubt.
  std::optional<Rounded> nearest() const {
    // Rounding is monotonic: what both bounds are rounded to, so is the number.
    if (high_ + (low_ - error_) == high_ && high_ + (low_ + error_) == high_)
      return Rounded{high_, std::abs(low_) > error_};
    return std::nullopt;
  }
  /// numerator / denominator, correctly rounded, if the errors leave no doubt.
  friend std::optional<Rounded> nearest_quotient(const Bounded& numerator,
                                                 const Bounded& denominator) {
    return quotient(numerator, denominator).nearest();
  }

  /// The root of a number that is not negative. For the root s of its first half and the rest r,
  /// that is s + r / 2s, less r² / 4s³ at most while r is below s² / 4.
  friend Bounded square_root(const Bounded& number) {
    const double root = std::sqrt(number.high_);
    const Bounded rest = number - Bounded(root) * Bounded(root);
    const double half = rest.high_ / (2 * root), doubt = std::abs(rest.low_) + rest.error_;
    if (!(std::abs(half) + doubt / root <= root / 16))
      return within(root, std::numeric_limits<double>::infinity());
    const double share = (std::abs(half) + doubt / root) / root;
    const double error =
        (doubt / root + 2 * share * share * root + 4 * unit * std::abs(half)) * (1 + 16 * unit) +
        16 * underflow;
    return normal(root, half, error);
  }

 private:
  static constexpr double unit = rounding::unit, underflow = rounding::underflow;

  Bounded(double high, double low, double error) : high_(high), low_(low), error_(error) {}

  bool is_zero() const { return high_ == 0 && low_ == 0 && error_ == 0; }

  // a + b - sum, for sum = a + b rounded.
  static double sum_error(double a, double b, double sum) {
    const double part = sum - a;
    return (a - (sum - part)) + (b - part);
  }
  // The same number, with low below half an ulp of high. Exact, since |high| >= |low|, or both are
  // of the size of the error.
  static Bounded normal(double high, double low, double error) {
    const double sum = high + low;
    return Bounded(sum, sum_error(high, low, sum), error);
  }

  double high_ = 0, low_ = 0, error_ = 0;
};

}  // namespace sectile
