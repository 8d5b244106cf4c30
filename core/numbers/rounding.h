// What bounds of rounding errors are made of.
#pragma once

#include <limits>

namespace sectile::rounding {

/// Half an ulp of 1: a rounded result is off by at most this share of it, but for underflow.
inline constexpr double unit = 0x1p-53;
/// The least positive double: underflow loses less.
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();

}  // namespace sectile::rounding
