// Faces that touch themselves: corners of theirs lie within edges of theirs.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/facets.h"

namespace sectile::arrangement {

/// Per face: does it? Convex ones do not. The walls that stand on such a face are divided where it
/// touches itself, so its edges are to be divided there, too.
std::vector<std::uint8_t> find_self_touching(const Facets& facets,
                                             const std::vector<std::uint8_t>& convex,
                                             const Kernel& kernel);

}  // namespace sectile::arrangement
