// Four floats side by side: one instruction is for all of them.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <bit>
#include <cstdint>

namespace sectile {

// An extension that GCC and Clang have in common.
using FourFloats = float __attribute__((vector_size(16)));
/// What comparing them gives: all bits of those for which it holds.
using FourTruths = std::int32_t __attribute__((vector_size(16)));

inline FourFloats broadcast(float v) {
  return FourFloats{v, v, v, v};
}

/// Bit i: truth i.
inline unsigned mask_of(FourTruths truths) {
#ifdef __SSE__
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(truths)));
#else
  const FourTruths each = truths & FourTruths{1, 2, 4, 8};
  return static_cast<unsigned>((each[0] | each[1]) | (each[2] | each[3]));
#endif
}

}  // namespace sectile
