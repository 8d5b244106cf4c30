// Work of many Booleans: what the profile looks at beside single ones.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sectile/boolean.h"
#include "sectile/solid.h"

namespace sectile::bench {

/// Performs a Boolean and looks at what it costs.
using Boolean = std::function<Solid(const Solid&, const Solid&, Operation)>;

struct Sequence {
  std::string name;
  /// Makes the operands; what it returns does the work, as often as it is called.
  std::function<std::function<void(const Boolean&)>()> prepare;
};

/// Those of the benchmarks, each operation on the same operands again and again, and longer work.
std::vector<Sequence> sequences();
/// Pairs of meshes from a folder (see cmake/real_meshes.sh) in arbitrary places; those that are
/// missing are left out. To prepare them throws InvalidSolid for those that are no solids.
std::vector<Sequence> real_pairs(const std::string& folder);

}  // namespace sectile::bench
