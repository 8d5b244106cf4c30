#include "complex.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sectile::test {
namespace {

using Point = Complex::Point;

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point unit(int axis) {
  Point p{};
  p[static_cast<std::size_t>(axis)] = 1;
  return p;
}
Point sum(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// Calls visit(lowest corner) for each unit cube, x first.
template <class Visit>
void for_each_cube(int size, const Visit& visit) {
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) visit(Point{x, y, z});
}

}  // namespace

Complex Complex::cubes(int size) {
  Complex complex;
  for_each_cube(size, [&](const Point& low) {
    std::vector<Corners> sides;
    for (int axis = 0; axis < 3; ++axis) {
      const Point n = unit(axis), u = unit((axis + 1) % 3), v = unit((axis + 2) % 3);
      sides.push_back({low, sum(low, v), sum(sum(low, u), v), sum(low, u)});
      const Point high = sum(low, n);
      sides.push_back({high, sum(high, u), sum(sum(high, u), v), sum(high, v)});
    }
    complex.add_cell(sides);
  });
  complex.connect();
  return complex;
}

Complex Complex::tetrahedra(int size) {
  Complex complex;
  for_each_cube(size, [&](const Point& low) {
    std::array<int, 3> order{0, 1, 2};
    do {
      std::array<Point, 4> p{low};
      for (std::size_t i = 0; i < 3; ++i) p[i + 1] = sum(p[i], unit(order[i]));
      if (dot(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0]))) < 0)
        std::swap(p[2], p[3]);
      complex.add_cell(
          {{p[1], p[2], p[3]}, {p[0], p[3], p[2]}, {p[0], p[1], p[3]}, {p[0], p[2], p[1]}});
    } while (std::next_permutation(order.begin(), order.end()));
  });
  complex.connect();
  return complex;
}

Complex Complex::fan() {
  constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1};
  Complex complex;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::size_t l = (k + 1) % 8;
    const auto corner = [&](std::size_t direction, int z) {
      return Point{x[direction], x[(direction + 6) % 8], z};
    };
    const Point p[2][3] = {{{0, 0, 0}, corner(k, 0), corner(l, 0)},
                           {{0, 0, 1}, corner(k, 1), corner(l, 1)}};
    complex.add_cell({{p[0][0], p[0][2], p[0][1]},
                      {p[1][0], p[1][1], p[1][2]},
                      {p[0][0], p[0][1], p[1][1], p[1][0]},
                      {p[0][1], p[0][2], p[1][2], p[1][1]},
                      {p[0][2], p[0][0], p[1][0], p[1][2]}});
  }
  complex.connect();
  return complex;
}

int Complex::point_number(const Point& p) {
  const auto found = std::find(points_.begin(), points_.end(), p);
  if (found != points_.end()) return static_cast<int>(found - points_.begin());
  points_.push_back(p);
  return static_cast<int>(points_.size()) - 1;
}

void Complex::add_cell(const std::vector<Corners>& sides) {
  Cell cell;
  const Point& apex = sides.front().front();
  int corner_count = 0;
  for (const Corners& corners : sides) {
    Side side;
    for (const Point& p : corners) {
      side.corners.push_back(point_number(p));
      cell.centre = {cell.centre.x + p[0], cell.centre.y + p[1], cell.centre.z + p[2]};
      ++corner_count;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Point u = minus(corners[i - 1], corners[0]), v = minus(corners[i], corners[0]);
      side.normal = cross(u, v);
      side.area += std::sqrt(dot(side.normal, side.normal)) / 2;
      cell.sixths += dot(minus(corners[0], apex), side.normal);
    }
    has_integer_areas_ &= side.area == std::floor(side.area);
    cell.sides.push_back(side);
  }
  // Every corner is in equally many sides, so this is the mean of the corners.
  cell.centre = {cell.centre.x / corner_count, cell.centre.y / corner_count,
                 cell.centre.z / corner_count};
  cells_.push_back(cell);
}

void Complex::connect() {
  std::map<std::vector<int>, std::pair<int, int>> open;
  for (int c = 0; c < cell_count(); ++c)
    for (int s = 0; s < static_cast<int>(cell(c).sides.size()); ++s) {
      std::vector<int> key = side(c, s).corners;
      std::sort(key.begin(), key.end());
      const auto [entry, first] = open.try_emplace(key, c, s);
      if (first) continue;
      const auto [other, t] = entry->second;
      const auto link = [&](int from, int from_side, int to, int to_side) {
        Side& linked =
            cells_[static_cast<std::size_t>(from)].sides[static_cast<std::size_t>(from_side)];
        linked.neighbour = to;
        linked.twin = to_side;
      };
      link(c, s, other, t);
      link(other, t, c, s);
    }
}

double Complex::volume(Mask mask) const {
  int sixths = 0;
  for (int c = 0; c < cell_count(); ++c)
    if (has(mask, c)) sixths += cell(c).sixths;
  return sixths / 6.0;
}

double Complex::area(Mask mask) const {
  double area = 0;
  for_each_exposed(mask, [&](int c, int s) { area += side(c, s).area; });
  return area;
}

}  // namespace sectile::test
