// The usual case: all corners go to the nearest places, and nothing meets that did not.
#pragma once

#include <optional>

#include "rounding/rounding_grid.h"
#include "rounding/rounding_steps.h"
#include "storage/solid_data.h"

namespace sectile {

/// The mesh, if this is so, and certain without a look at the whole: most corners have not moved,
/// the triangles with a moved corner meet nothing in their surroundings, and there is one shell.
/// Works block by block. Nothing does not mean that it is not so.
std::optional<RoundedMesh> plain_rounding(const SolidData& data, const RoundingGrid& grid,
                                          RoundingSteps& steps);

}  // namespace sectile
