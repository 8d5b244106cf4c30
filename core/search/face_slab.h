// Two parallel planes around a face, for a quick test that all in a box is apart from it.
#pragma once

#include <span>

#include "search/box.h"

namespace sectile {

/// Low ≤ normal · x ≤ high for the points of a polygon: both are nearly the same, as it is plane.
class FaceSlab {
 public:
  FaceSlab() = default;
  /// Around the corners of a polygon, at least three, that are known up to half an ulp in each
  /// coordinate.
  explicit FaceSlab(std::span<const Vec3> corners);

  /// Certainly? Never true of a box that the polygon meets.
  friend bool apart(const FaceSlab& slab, const Box& box);

 private:
  Vec3 normal_;
  double low_ = 0, high_ = 0;
  double error_ = 0;   // of products with the corners
  double weight_ = 0;  // times the reach of others: the error of products with them
};

}  // namespace sectile
