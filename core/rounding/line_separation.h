// Wedges of material along one line, on whose edges corners of others lie: each gets ends of its
// own within its sector of what is around the line.
//
// Else each would get the corners of all others on its edges when these are rounded, and as many
// vertices would have to be moved apart as there are pairs.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/kernel.h"
#include "rounding/common_lines.h"
#include "rounding/edge_sectors.h"
#include "rounding/rounding_grid.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Are there many corners on each of the edges that have any?
bool are_crowded(std::span<const CornerOnEdge> on_edges);

class LineSeparation {
 public:
  /// The exact surface of a solid. Adds to the geometry, which is the kernel's.
  LineSeparation(TriangleSurface& surface, Geometry& geometry, Kernel& kernel,
                 const RoundingGrid& grid)
      : surface_(surface), geometry_(geometry), kernel_(kernel), grid_(grid) {}

  /// Looks at the lines of edges with corners on them. All wedges of a line are separated, if each
  /// has a sector with numbers of the grid in it, and the triangles at its ends are there, too.
  void run(std::span<const CornerOnEdge> on_edges);

  /// A point that is a number of the grid, in the place of another one on the line.
  struct Separated {
    PointId point, from;
  };
  /// Ascending.
  std::span<const Separated> separated() const { return separated_; }

 private:
  // An edge on a line, which goes up there in this triangle.
  struct Side {
    PointPair edge;
    std::uint32_t triangle, k;
  };
  struct Corner {
    std::uint32_t triangle, k;
  };
  // What is to be at another place.
  struct End {
    std::vector<Corner> corners;
    PointId from;
    Vec3 to;
  };

  std::vector<Side> edges_between(std::span<const PointId> points) const;
  void separate(const EdgesOfLine& line, std::span<const PointId> points,
                std::span<const Side> edges);
  EdgeSectors::Side side(std::uint32_t triangle, std::size_t k) const;
  bool add_end(Corner corner, std::span<const PointId> on_line, const EdgeSectors::Wedge& wedge,
               std::span<const PlaneId> sector, std::vector<End>& ends);
  double step_around(const End& end) const;
  bool find_place(End& end, const EdgeSectors::Wedge& wedge, std::span<const PlaneId> sector);
  Corner mate(Corner corner) const;

  TriangleSurface& surface_;
  Geometry& geometry_;
  Kernel& kernel_;
  const RoundingGrid& grid_;
  std::vector<Separated> separated_;
};

}  // namespace sectile
