// One operation over several operands.
#pragma once

#include <vector>

#include "sectile/boolean.h"

namespace sectile::cli {

/// The union of all, the intersection of all, or the first minus all others. At least two.
Solid fold(std::vector<Solid> operands, Operation operation, const BooleanOptions& options);

}  // namespace sectile::cli
