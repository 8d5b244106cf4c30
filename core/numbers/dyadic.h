// Exact numbers m · 2^e with integers m of any length: what sums and products of doubles are.
#pragma once

#include <cstdint>

#include "numbers/sign.h"

namespace sectile {

class Dyadic {
 public:
  Dyadic();                        ///< zero
  explicit Dyadic(double value);   ///< exactly; value must be finite
  Sign sign() const;
  double nearest() const;          ///< rounded to nearest, ties to even; infinite on overflow

  Dyadic operator-() const;
  friend Dyadic operator+(const Dyadic&, const Dyadic&);
  friend Dyadic operator-(const Dyadic&, const Dyadic&);
  friend Dyadic operator*(const Dyadic&, const Dyadic&);
};

/// numerator / denominator, correctly rounded. The denominator is not zero.
double nearest_quotient(const Dyadic& numerator, const Dyadic& denominator);

/// The exact sign of a[0]·b[0] + … + a[count-1]·b[count-1], for finite doubles of any size.
Sign sign_of_dot(const double* a, const double* b, int count);

}  // namespace sectile
