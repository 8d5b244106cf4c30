// What bounds of rounding errors are made of.
#pragma once

namespace sectile::rounding {

/// Half an ulp of 1: a rounded result is off by at most this share of it, but for underflow.
inline constexpr double unit = 0x1p-53;
/// Underflow loses less, by far. Products with it are normal doubles, as those with the least one
/// are not, and thereby many times as fast.
inline constexpr double underflow = 0x1p-900;

}  // namespace sectile::rounding
