// Solids from the cells of an arrangement.
#pragma once

#include <memory>

#include "arrangement/solid_boundaries.h"

namespace sectile::arrangement {

/// Which edges between parts of one face, and corners on straight edges, may go.
enum class Merging {
  all,    ///< all that the result does not need
  shared  ///< those that no cell needs, so that cells that touch have the same faces there
};

/// One of the solids, or the empty solid if it has no cell. Faces have the plane and the source of
/// the lowest face that lies there. Goes from 0.8 to 1 of the work.
std::shared_ptr<SolidData> solid_of(const SubFaces& faces, const Cells& cells, const Facets& facets,
                                    const Geometry& geometry, const Kernel& kernel,
                                    const CellsOfSolids& solids, std::uint32_t solid,
                                    const SolidBoundary& boundary, Merging merging,
                                    const Steering& steering);
/// The solid of all cells that are marked with 0.
std::shared_ptr<SolidData> solid_of(const SubFaces& faces, const Cells& cells, const Facets& facets,
                                    const Geometry& geometry, const Kernel& kernel,
                                    const CellsOfSolids& marked, Merging merging,
                                    const Steering& steering);

}  // namespace sectile::arrangement
