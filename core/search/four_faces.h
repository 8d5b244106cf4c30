// Faces side by side, which are compared with another one, or with a box, at one go: most that do
// not meet it lie on one side of its plane, or it lies on one side of theirs.
#pragma once

#include <span>

#include "search/box.h"
#include "search/four_floats.h"

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
  struct Place {
    FourFloats x, y, z;
  };
  static Place repeated(const Place& of, unsigned i) {
    return {broadcast(of.x[i]), broadcast(of.y[i]), broadcast(of.z[i])};
  }
  static FourFloats product(const Place& p, const Place& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }

  // Low ≤ normal · p ≤ high for the points of a face. The error of such a product with corners
  // whose coordinates are up to a reach is below weight · reach.
  Place normal_;
  FourFloats low_, high_, weight_;
  FourFloats reach_;   // the greatest size of a coordinate
  Place corner_[4];    // of a triangle, the last one twice; not numbers if there are more
  unsigned most_ = 3;  // corners that differ
};

// What is not a number is on no side.
inline unsigned FourFaces::apart_from(const FourFaces& others, unsigned i) const {
  constexpr float least = 0x1p-140f;  // of products that are too small for floats
  const Place normal = repeated(normal_, i);
  const FourFloats error = broadcast(weight_[i]) * others.reach_ + least;
  const FourFloats above = broadcast(high_[i]) + error, below = broadcast(low_[i]) - error;
  FourTruths over = ~FourTruths{}, under = over;
  for (unsigned k = 0; k < others.most_; ++k) {
    const FourFloats at = product(normal, others.corner_[k]);
    over &= at > above;
    under &= at < below;
  }
  const FourFloats their_error = others.weight_ * reach_[i] + least;
  const FourFloats over_theirs = others.high_ + their_error,
                   under_theirs = others.low_ - their_error;
  FourTruths is_over = ~FourTruths{}, is_under = is_over;
  for (unsigned k = 0; k < most_; ++k) {
    const FourFloats at = product(others.normal_, repeated(corner_[k], i));
    is_over &= at > over_theirs;
    is_under &= at < under_theirs;
  }
  return mask_of(over | under | is_over | is_under);
}

}  // namespace sectile
