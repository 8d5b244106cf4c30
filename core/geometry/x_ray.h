// Which faces a ray in direction +x meets, by the projection of their edges to (y, z). Of a ray
// along another axis, y and z are the two next ones.
#pragma once

#include "numbers/sign.h"

namespace sectile {

/// Counts the edges of one face around the projection of the ray. The ray's start is taken to be
/// moved by (+ε, -δ) with δ far greater than ε, so that it lies on no projected edge or vertex: an
/// edge that ends level with it counts as below, an edge through it as above.
class XRayParity {
 public:
  /// An edge from u to v. `above_u`: is u's y greater than that of the ray? turn() is that of u, v
  /// and the ray's start seen against the x axis; it is asked only if it matters.
  template <class Turn>
  void add(bool above_u, bool above_v, const Turn& turn) {
    if (above_u == above_v) return;
    // With y to the right and z up: an edge to the right passes above what is on its right.
    const Sign sign = turn();
    if (sign == Sign::zero || (sign == Sign::negative) == above_v) odd_ = !odd_;
  }
  /// After all edges: does the ray go through the projection of the face?
  bool odd() const { return odd_; }

 private:
  bool odd_ = false;
};

}  // namespace sectile
