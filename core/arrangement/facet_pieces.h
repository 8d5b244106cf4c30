// Faces in pieces, where very many lie in holes and bends of others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/facets.h"
#include "search/face_pieces.h"

namespace sectile::arrangement {

/// Faces that leave much of their boxes empty, ascending.
std::vector<std::uint32_t> hollow_facets(const Facets& facets, const Geometry& geometry);

/// The others as a whole.
FacePieces facet_pieces(const Facets& facets, std::span<const std::uint32_t> hollow,
                        const Kernel& kernel);

}  // namespace sectile::arrangement
