// Phase 6: the cut surfaces fall apart; which pieces stay in the result.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Per solid: which faces are in the boundary of a result.
struct KeptFaces {
  std::vector<std::uint8_t> loaded[2];  ///< per face of the patch
  std::vector<std::uint8_t> rest[2];    ///< per face of the operand that is not loaded (or empty)
};

/// Classes spread from the contact segments; all that reach one piece must agree. A shell that
/// touches nothing takes one exact ray.
KeptFaces find_components(Workspace& w, Operation operation);

}  // namespace sectile
