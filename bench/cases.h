// The cases that the benchmarks time.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sectile/boolean.h"
#include "sectile/solid.h"

namespace sectile::bench {

/// Makes both operands anew, so that nothing (say, a search tree) is kept from an earlier run.
using MakeOperands = std::function<std::pair<Solid, Solid>()>;

struct Case {
  std::string name;
  Operation operation;
  std::function<MakeOperands()> prepare;  ///< does what is not to be timed, such as raw meshes
};

std::vector<Case> cases();

}  // namespace sectile::bench
