// Boxes side by side, which are compared with another one at one go.
#pragma once

#include <array>
#include <limits>

#include "search/box.h"
#include "search/four_floats.h"

namespace sectile {

/// Those that are not set are nowhere, and overlap nothing, not even what is everywhere.
class FourBoxes {
 public:
  FourBoxes() { low_.fill(nowhere), high_.fill(nowhere); }

  void set(unsigned i, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k][i] = box.low[k];
      high_[k][i] = box.high[k];
    }
  }
  Box get(unsigned i) const {
    return {{low_[0][i], low_[1][i], low_[2][i]}, {high_[0][i], high_[1][i], high_[2][i]}};
  }
  /// Around those that are set.
  Box all() const {
    Box box;
    for (unsigned i = 0; i < 4; ++i) box.add(get(i));
    return box;
  }
  /// Bit i: box i overlaps another one.
  unsigned overlapping(const Box& box) const {
    return mask_of((low_[0] <= box.high[0]) & (high_[0] >= box.low[0]) & (low_[1] <= box.high[1]) &
                   (high_[1] >= box.low[1]) & (low_[2] <= box.high[2]) & (high_[2] >= box.low[2]));
  }

 private:
  // No comparison with these holds.
  static constexpr float none = std::numeric_limits<float>::quiet_NaN();
  static constexpr FourFloats nowhere{none, none, none, none};

  std::array<FourFloats, 3> low_, high_;
};

class EightBoxes {
 public:
  void set(unsigned i, const Box& box) { halves_[i / 4].set(i % 4, box); }
  Box get(unsigned i) const { return halves_[i / 4].get(i % 4); }
  Box all() const {
    Box box = halves_[0].all();
    box.add(halves_[1].all());
    return box;
  }
  /// Bit i: box i overlaps another one.
  unsigned overlapping(const Box& box) const {
    return halves_[0].overlapping(box) | halves_[1].overlapping(box) << 4;
  }

 private:
  std::array<FourBoxes, 2> halves_;
};

}  // namespace sectile
