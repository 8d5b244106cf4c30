// How the edges of rows are divided in one solid.
#pragma once

#include <vector>

#include "arrangement/solid_boundaries.h"

namespace sectile::arrangement {

/// A part of a sub-face's edge along which it bounds one wedge of material. There is one other part
/// that bounds the same wedge, between the same places.
struct RowPart {
  std::uint32_t corner;
  std::uint32_t from, to;  ///< places of the row
  std::uint32_t wedge;     ///< 0, 1 …
  PointId begin, end;      ///< at these places
  bool forward;            ///< does the half-edge run from the first place to the second one?
};

/// Those of all sub-faces that bound one of the solids, at its rows: by corners, along the lines.
std::vector<RowPart> row_parts(const Cells& cells, const CellsOfSolids& solids, std::uint32_t solid,
                               const std::vector<std::uint32_t>& rows);

}  // namespace sectile::arrangement
