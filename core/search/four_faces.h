// Faces side by side, which are compared with another one, or with a box, at one go: most that do
// not meet it lie on one side of its plane, or it lies on one side of theirs.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "search/box.h"

namespace sectile {

class FourFaces {
 public:
  /// None of them is known to be apart from anything.
  FourFaces();
  /// Around the corners of a polygon, at least three, that are known up to half an ulp in each
  /// coordinate.
  void set(unsigned i, std::span<const Vec3> corners);

  /// Bit i: face i is certainly apart from all that is in a box; never one that meets it.
  unsigned apart_from(const Box& box) const;
  /// Bit j: face i is certainly apart from face j of others; never one that it meets.
  unsigned apart_from(const FourFaces& others, unsigned i) const;

 private:
  // One instruction is for four numbers, as in FourBoxes.
  using Floats = float __attribute__((vector_size(16)));
  using Truths = std::int32_t __attribute__((vector_size(16)));
  struct Place {
    Floats x, y, z;
  };
  static Floats four(float v) { return Floats{v, v, v, v}; }
  static Place four(const Place& of, unsigned i) {
    return {four(of.x[i]), four(of.y[i]), four(of.z[i])};
  }
  static Floats product(const Place& p, const Place& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }
  static unsigned bits(Truths truths);

  // Low ≤ normal · p ≤ high for the points of a face. The error of such a product with corners
  // whose coordinates are up to a reach is below weight · reach.
  Place normal_;
  Floats low_, high_, weight_;
  Floats reach_;       // the greatest size of a coordinate
  Place corner_[4];    // of a triangle, the last one twice; not numbers if there are more
  unsigned most_ = 3;  // corners that differ
};

inline unsigned FourFaces::bits(Truths truths) {
#ifdef __SSE__
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(truths)));
#else
  const Truths each = truths & Truths{1, 2, 4, 8};
  return static_cast<unsigned>((each[0] | each[1]) | (each[2] | each[3]));
#endif
}

// What is not a number is on no side.
inline unsigned FourFaces::apart_from(const FourFaces& others, unsigned i) const {
  constexpr float least = 0x1p-140f;  // of products that are too small for floats
  const Place normal = four(normal_, i);
  const Floats error = four(weight_[i]) * others.reach_ + least;
  const Floats above = four(high_[i]) + error, below = four(low_[i]) - error;
  Truths over = ~Truths{}, under = over;
  for (unsigned k = 0; k < others.most_; ++k) {
    const Floats at = product(normal, others.corner_[k]);
    over &= at > above;
    under &= at < below;
  }
  const Floats their_error = others.weight_ * reach_[i] + least;
  const Floats over_theirs = others.high_ + their_error, under_theirs = others.low_ - their_error;
  Truths is_over = ~Truths{}, is_under = is_over;
  for (unsigned k = 0; k < most_; ++k) {
    const Floats at = product(others.normal_, four(corner_[k], i));
    is_over &= at > over_theirs;
    is_under &= at < under_theirs;
  }
  return bits(over | under | is_over | is_under);
}

}  // namespace sectile
