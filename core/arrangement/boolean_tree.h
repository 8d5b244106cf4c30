// One operation on many solids, as a tree of Booleans of two.
#pragma once

#include <vector>

#include "arrangement/steering.h"
#include "sectile/boolean.h"

namespace sectile::arrangement {

/// `unite` or `intersect`; none of the solids is empty. Neighbours in space come together first,
/// all cores work on different branches, and what lies inside is gone before it can meet the rest.
Solid combine(const std::vector<Solid>& solids, Operation operation, const Steering& steering);

}  // namespace sectile::arrangement
