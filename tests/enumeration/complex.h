// A block of space divided into small convex cells with integer corners, of which solids are made
// by choosing cells: everything about such a solid (and about any union, intersection or difference
// of two) can be counted, independently of the library.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

/// A set of cells; bit i is cell i. There are at most 64.
using Mask = std::uint64_t;

class Complex {
 public:
  using Point = std::array<int, 3>;

  struct Side {
    std::vector<int> corners;  ///< counter-clockwise from outside the cell
    int neighbour = -1;        ///< the cell beyond, if any
    int twin = -1;             ///< which side of the neighbour this is
    double area = 0;
    Point normal{};
  };
  struct Cell {
    std::vector<Side> sides;
    int sixths = 0;  ///< of a unit of volume
    Vec3 centre;     ///< in the interior
  };

  /// size³ unit cubes; cube (x, y, z) is cell x + size·(y + size·z).
  static Complex cubes(int size);
  /// The same cubes, each divided into six tetrahedra around its diagonal from the lowest to the
  /// highest corner (Kuhn). Neighbouring cubes share the diagonals of their squares.
  static Complex tetrahedra(int size);

  /// Eight prisms around the edge from (0, 0, 0) to (0, 0, 1), each of 45 degrees.
  static Complex fan();

  int cell_count() const { return static_cast<int>(cells_.size()); }
  Mask all() const { return ~Mask{0} >> (64 - cell_count()); }
  const Cell& cell(int i) const { return cells_[static_cast<std::size_t>(i)]; }
  const Side& side(int c, int s) const { return cell(c).sides[static_cast<std::size_t>(s)]; }
  const Point& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  static bool has(Mask mask, int c) { return c >= 0 && (mask >> c & 1) != 0; }
  double volume(Mask mask) const;
  double area(Mask mask) const;
  /// Whether all areas are sums of small integers, so that sums of doubles are exact.
  bool has_integer_areas() const { return has_integer_areas_; }

  /// Calls visit(cell, side) for each side between the set and what is not in it.
  template <class Visit>
  void for_each_exposed(Mask mask, const Visit& visit) const {
    for (int c = 0; c < cell_count(); ++c)
      if (has(mask, c))
        for (int s = 0; s < static_cast<int>(cell(c).sides.size()); ++s)
          if (!has(mask, side(c, s).neighbour)) visit(c, s);
  }

 private:
  using Corners = std::vector<Point>;
  int point_number(const Point& p);
  void add_cell(const std::vector<Corners>& sides);
  void connect();

  std::vector<Point> points_;
  std::vector<Cell> cells_;
  bool has_integer_areas_ = true;
};

}  // namespace sectile::test
