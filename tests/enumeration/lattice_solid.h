// A solid whose faces lie in planes through integer points, read back in exact integers.
#pragma once

#include "polytope.h"
#include "sectile/solid.h"

namespace sectile::test {

/// Sorted, each once.
std::vector<LatticePoint> exact_corners(const Solid& solid);
Rational exact_volume(const Solid& solid);

}  // namespace sectile::test
