// The invariants of the half-edge structure that need no geometry.
#pragma once

#include <string>
#include <vector>

#include "topology/brep.h"

namespace sectile {

/// Checks next and prev, loops and faces, cycles around vertices, and Euler and Poincaré's formula.
/// Says in words what is broken; empty if all is well. `unbounded`: the boundary of a
/// half-space, which has a face without an outer loop and obeys no such formula.
std::vector<std::string> broken_links(const Brep& brep, bool unbounded);

}  // namespace sectile
