#pragma once

#include "boolean/loading/load.h"
#include "sectile/solid.h"

namespace sectile::test {

/// How many pairs of faces a union of two solids looks at.
inline std::size_t count_pairs(const Solid& a, const Solid& b) {
  const BooleanOptions options;
  Workspace w(options);
  FacePairs pairs;
  const Operation unite[] = {Operation::unite};
  load(w, a.data()->in_one_block(), b.data()->in_one_block(), pairs, {unite, false, false});
  return pairs.size();
}

}  // namespace sectile::test
