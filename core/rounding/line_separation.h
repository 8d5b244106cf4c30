// Wedges of material along one line, on whose edges corners of others lie: each gets ends of its
// own within its sector of what is around the line, or within its own material, if it is not alone
// in its directions.
//
// Else each would get the corners of all others on its edges when these are rounded, and as many
// vertices would have to be moved apart as there are pairs.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/kernel.h"
#include "rounding/common_lines.h"
#include "rounding/edge_sectors.h"
#include "rounding/rounding_grid.h"
#include "search/places_on_line.h"
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

  /// Looks at the lines of edges with corners on them. A wedge is separated if there are numbers of
  /// the grid in its room, and the triangles at its ends are there, too.
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
    std::vector<Corner> star;  // the triangles there; none if it has to stay
    PointId from;
    Vec3 to;
  };
  // What is along one line.
  struct Book {
    PlacesOnLine places;
    std::vector<EdgeSectors::Wedge> wedges;
    std::vector<std::array<End, 2>> ends;  // of each wedge's edge
  };
  // Half-spaces with places for an end in all of them.
  struct Room {
    std::vector<PlaneId> planes;
    Vec3 amid;         // a way from the end
    double clearance;  // steps from all that bounds it
  };

  void find_points(std::span<const CornerOnEdge> on_edges);
  std::vector<Side> edges_between_points();
  std::vector<PointId> points_on(const EdgesOfLine& line, std::span<const CornerOnEdge> on_edges);
  Book book_of(const EdgesOfLine& line, std::span<const PointId> on_line,
               std::span<const Side> edges) const;
  void separate(Book& book, std::span<const PointId> on_line);
  void move(const std::array<End, 2>& ends);
  End end_at(Corner corner, std::span<const PointId> on_line) const;
  std::vector<std::vector<PlaneId>> sectors_of(const Book& book,
                                               const std::vector<bool>& have_others);
  std::vector<bool> have_others_on_edges(const Book& book, std::span<const PointId> on_line) const;
  bool find_places(std::array<End, 2>& ends, const EdgeSectors::Wedge& wedge,
                   std::span<const PlaneId> sector, double clearance);
  Room room_in_sector(const End& end, const EdgeSectors::Wedge& wedge,
                      std::span<const PlaneId> sector) const;
  Room room_in_material(const End& end) const;
  bool has_star_in(const End& end, const Room& room) const;
  double step_around(const End& end) const;
  bool find_place(End& end, const Room& room);
  EdgeSectors::Side side(Corner corner) const;
  Corner mate(Corner corner) const;

  TriangleSurface& surface_;
  Geometry& geometry_;
  Kernel& kernel_;
  const RoundingGrid& grid_;
  std::vector<PointId> points_;         // on lines, ascending
  std::vector<bool> is_on_line_;        // per point of the geometry, while those of one are sought
  std::vector<std::uint32_t> corners_;  // of triangles, in each of them
  std::vector<Separated> separated_;
};

}  // namespace sectile
