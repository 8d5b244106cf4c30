// Small solids on a coarse lattice, so that many of them touch, and maps that keep them there or
// not.
#pragma once

#include <random>

#include "sectile/sectile.h"

namespace sectile::test {

class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : random_(seed) {}

  int number(int low, int high);
  double real(int low, int high) { return number(low, high); }
  /// A block, tetrahedron, wedge, ball, prism or some unit cells, in [0, 3]³ for the most part.
  Solid shape();
  /// Any affine map: shifts, swaps of axes, exact and rounded rotations, shears, scalings, and
  /// rotations and shifts by next to nothing.
  Transform map();
  HalfSpace half_space();

 private:
  template <class Make>
  Solid in_box(const Make& make);
  Solid tetrahedron();
  Solid cells();

  std::mt19937 random_;
};

}  // namespace sectile::test
