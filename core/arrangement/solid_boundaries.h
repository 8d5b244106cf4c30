// What bounds the solids that are made of cells of an arrangement: of many solids each has little.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/cells.h"

namespace sectile::arrangement {

/// Sub-faces between the cells of a solid and others, and the fans and rows of edges at which they
/// are; all ascending.
struct SolidBoundary {
  std::vector<std::uint32_t> faces, fans, rows;
};

/// Cells by the solids that they belong to.
struct CellsOfSolids {
  std::vector<std::uint32_t> solid;  ///< per cell: its solid, or none
  std::size_t count;                 ///< of solids

  /// Those of solids 0, 1 …
  std::vector<SolidBoundary> boundaries(const Cells& cells) const;
};

}  // namespace sectile::arrangement
