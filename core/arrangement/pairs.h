// Pairs of faces that may meet other than in common corners and edges.
#pragma once

#include <vector>

#include "arrangement/crowded_points.h"
#include "arrangement/facet_tree.h"
#include "arrangement/steering.h"
#include "search/edges_by_line.h"

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

/// What becomes of the edges on a line along which very many run, all with ends of their own.
enum class Crowds {
  divided,  ///< they are divided where others end
  in_rows   ///< they stay whole (row_lines.h)
};

struct Pairs {
  std::vector<FacePair> pairs;  ///< in order
  /// Lines along which very many edges run, between two points. Of faces that meet in corners and
  /// edges on such a line only, not all are in pairs.
  std::vector<PointPair> crowded_lines;
  /// Of faces that meet in such a point only, not all are in pairs.
  std::vector<CrowdedPoint> crowded_points;
};

/// All pairs that may meet. Crowded points are looked for where there are many pairs, and crowded
/// lines if they may stay whole, too.
Pairs find_pairs(const Facets& facets, const FacetTree& tree,
                 const std::vector<std::uint8_t>& convex, const Kernel& kernel, Crowds crowds,
                 const Steering& steering);

}  // namespace sectile::arrangement
