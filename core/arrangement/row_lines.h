// Lines along which very many edges run, all with ends of their own.
#pragma once

#include <span>
#include <vector>

#include "arrangement/traces.h"
#include "search/edges_by_line.h"

namespace sectile::arrangement {

/// Along these lines no edge is divided where another one ends: what is around them is a row
/// (edge_rows.h), which says so much of each stretch.
class RowLines {
 public:
  RowLines() = default;
  /// Between these points, by number. To each line belong all edges of faces and all traces on it
  /// that overlap it, and what overlaps these.
  RowLines(const Facets& facets, const Traces& traces, std::span<const PointPair> lines,
           const Kernel& kernel);

  bool empty() const { return on_.empty(); }
  /// The line to which the edge or trace between two points belongs, or none.
  std::uint32_t of(PointId p, PointId q) const { return empty() ? none : line_through(p, q); }

  /// A point, and a line on which it is.
  struct On {
    PointId point;
    std::uint32_t line;
    friend auto operator<=>(const On&, const On&) = default;
  };

 private:
  std::uint32_t line_through(PointId p, PointId q) const;
  std::span<const On> lines_of(PointId p) const;

  std::vector<On> on_;  // ascending
};

}  // namespace sectile::arrangement
