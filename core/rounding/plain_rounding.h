// The usual case: most corners have their places, and what rounding makes meet is mended nearby.
#pragma once

#include <optional>

#include "rounding/rounding_grid.h"
#include "rounding/rounding_steps.h"
#include "storage/solid_data.h"

namespace sectile {

/// The mesh, if no look at the whole is needed for it: most corners stay, and where triangles
/// with a moved corner meet something, other diagonals or moves of corners nearby make them legal.
/// Works block by block. Nothing does not mean that it cannot be had.
std::optional<RoundedMesh> plain_rounding(const SolidData& data, const RoundingGrid& grid,
                                          const Rounding& options, RoundingSteps& steps);

}  // namespace sectile
