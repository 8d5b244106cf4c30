// Pairs of faces that may meet other than in common corners and edges.
#pragma once

#include <vector>

#include "arrangement/facet_tree.h"
#include "arrangement/steering.h"

namespace sectile::arrangement {

enum class Meeting : std::uint8_t {
  crossing,     ///< in different planes; each reaches the other's
  touching,     ///< in one plane, on different sides of a line; some corner may be on an edge
  overlapping,  ///< in one plane, and no line was found to separate them
};

struct FacePair {
  std::uint32_t f, g;  ///< f < g
  Meeting how;
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

/// Is the face one loop without a turn to the right or back?
std::vector<std::uint8_t> find_convex(const Facets& facets, const Kernel& kernel);

/// All pairs that may meet, in order.
std::vector<FacePair> find_pairs(const Facets& facets, const FacetTree& tree,
                                 const std::vector<std::uint8_t>& convex, const Kernel& kernel,
                                 const Steering& steering);

}  // namespace sectile::arrangement
