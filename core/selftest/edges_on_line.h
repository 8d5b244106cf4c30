// The edges of a surface on one line along which very many run: does the material alternate around
// each stretch of it? Looking at each two of them takes time with the square of their number; so
// would sorting what is around each stretch, where all edges have different ends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/places_on_line.h"
#include "selftest/triangle_surface.h"
#include "selftest/wedge_order.h"

namespace sectile {

class EdgesOnLine {
 public:
  /// The edges of some triangles between points of the line, which are ascending.
  EdgesOnLine(const TriangleSurface& surface, const Kernel& kernel,
              std::span<const std::uint32_t> triangles, std::span<const PointId> points);

  /// True: each two of the edges meet as TrianglePairs demands. The material alternates with the
  /// outside around each two edges, and not only around all together, if the two sides of each are
  /// neighbours around the line, and bound material everywhere, or the outside everywhere.
  bool alternate() const;

 private:
  struct Edge {
    std::uint32_t triangle, across;
    bool up;                // in the triangle
    std::size_t low, high;  // numbers of the places between which it runs
  };

  void find_edges(std::span<const std::uint32_t> triangles);
  bool is_ignored(std::uint32_t t) const {
    return !surface_.ignored.empty() && surface_.ignored[t] != 0;
  }
  std::vector<SideOfLine> sides() const;

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  std::span<const PointId> points_;
  PlacesOnLine places_;
  std::vector<Edge> edges_;
  bool divided_ = false;  // is there an edge that is divided on one side only?
};

}  // namespace sectile
