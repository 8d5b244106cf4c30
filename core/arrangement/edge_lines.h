// The lines of edges, as planes that meet in them.
#pragma once

#include <vector>

#include "arrangement/facets.h"

namespace sectile::arrangement {

/// Two planes that meet in the line, and two given points of it, if they are known.
struct EdgeLine {
  PlaneId a, b;
  PointId from, to;
};

/// The lines of all edges of some faces. Edges between the same two points have the same line.
class EdgeLines {
 public:
  /// May add planes to the geometry that pin down edges.
  EdgeLines(const Facets& facets, const std::vector<std::uint8_t>& wanted, Geometry& geometry,
            Kernel& kernel);

  const EdgeLine& line(std::uint32_t corner) const { return lines_[line_of_[corner]]; }
  /// A plane through the edge that leaves a corner, not parallel to that of the corner's face.
  PlaneId across(std::uint32_t corner) const { return across_[corner]; }

  /// The point in which a plane cuts the line of the edge that leaves a corner.
  Construction cut(std::uint32_t corner, PlaneId plane) const {
    const EdgeLine& l = line(corner);
    return {l.a, l.b, plane, l.from, l.to};
  }

 private:
  std::vector<std::uint32_t> line_of_;  // per corner
  std::vector<PlaneId> across_;         // per corner
  std::vector<EdgeLine> lines_;
};

}  // namespace sectile::arrangement
