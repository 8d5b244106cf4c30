// A box around directions in which something is seen.
#pragma once

#include <algorithm>
#include <cmath>

#include "numbers/rounding.h"
#include "search/box.h"

namespace sectile {

/// Collects directions. With an angle of at most 60 degrees between any two of them, every
/// direction between them is near the box of their unit vectors. The bounds of rounding errors only
/// make the box wider; what boxes do not separate is tested exactly.
class Directions {
 public:
  /// That of a vector which is known up to an error in its length.
  void add(const Vec3& d, double error) {
    const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    if (!(length > least_length && length < greatest_length)) {
      known_ = false;
      return;
    }
    bounds_.add({d.x / length, d.y / length, d.z / length});
    error_ = std::max(error_, 2 * error / length);
  }

  Box box() const {
    if (!known_) return Box::everything();
    const Vec3 size{bounds_.high.x - bounds_.low.x, bounds_.high.y - bounds_.low.y,
                    bounds_.high.z - bounds_.low.z};
    const double spread = size.x * size.x + size.y * size.y + size.z * size.z + 8 * error_;
    if (!(spread <= 1)) return Box::everything();
    // A sum of unit vectors that are `sqrt(spread)` apart at most, with weights that add up to one,
    // is longer than sqrt(1 - spread / 2), and that than 1 - spread / 2. Square root, quotients and
    // these sums are rounded less than 16 times.
    const double margin = spread / 2 + 2 * error_ + 16 * rounding::unit;
    Bounds wider;
    wider.add({bounds_.low.x - margin, bounds_.low.y - margin, bounds_.low.z - margin});
    wider.add({bounds_.high.x + margin, bounds_.high.y + margin, bounds_.high.z + margin});
    return wider.box();
  }

 private:
  // A length within these bounds has a square that is a normal double.
  static constexpr double least_length = 0x1p-500, greatest_length = 0x1p500;

  Bounds bounds_;
  double error_ = 0;
  bool known_ = true;
};

}  // namespace sectile
