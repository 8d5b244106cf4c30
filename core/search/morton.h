// Places along a curve that fills space: neighbours on it are neighbours in space.
#pragma once

#include <cmath>
#include <cstdint>

#include "search/box.h"

namespace sectile {

/// Spreads the low ten bits to every third bit.
inline std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFu;
  x = (x | (x << 8)) & 0x0300F00Fu;
  x = (x | (x << 4)) & 0x030C30C3u;
  return (x | (x << 2)) & 0x09249249u;
}

/// The place of a point, or of a box's centre, in a grid of 1024³ cells.
class Morton {
 public:
  static constexpr unsigned bits = 30;

  explicit Morton(const Box& bounds) {
    for (int k = 0; k < 3; ++k) {
      low_[k] = bounds.low[k];
      const double extent = double(bounds.high[k]) - bounds.low[k];
      scale_[k] = extent > 0 && std::isfinite(extent) ? 1024.0 / extent : 0.0;
    }
  }
  std::uint32_t operator()(const Box& box) const {
    const auto middle = [&](int k) { return 0.5 * (double(box.low[k]) + box.high[k]); };
    return (*this)(Vec3{middle(0), middle(1), middle(2)});
  }
  std::uint32_t operator()(const Vec3& place) const {
    const double at[3] = {place.x, place.y, place.z};
    std::uint32_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const double cell = (at[k] - low_[k]) * scale_[k];
      key |= spread_bits(cell >= 1023 ? 1023u
                         : cell > 0   ? static_cast<std::uint32_t>(cell)
                                      : 0u)
             << k;
    }
    return key;
  }

 private:
  double low_[3], scale_[3];
};

}  // namespace sectile
