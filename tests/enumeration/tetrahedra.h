// Solids that are made of tetrahedra, and the volume that two of them share: each pair of
// tetrahedra is clipped in rational numbers, without the library's help.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

using ExactFraction = boost::multiprecision::cpp_rational;

/// Tetrahedra a, b, c, d of positive volume: seen from a, the corners b, c, d are clockwise. They
/// fill what they fill once, and share whole faces.
struct Tetrahedra {
  std::vector<Vec3> corners;
  std::vector<std::array<std::uint32_t, 4>> cells;

  /// Faces that two of them share are not part of it.
  PolygonMesh boundary() const {
    std::map<std::array<std::uint32_t, 3>, std::array<std::uint32_t, 3>> faces;
    for (const auto& [a, b, c, d] : cells)
      for (const auto& face : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}}) {
        std::array<std::uint32_t, 3> key = face;
        std::sort(key.begin(), key.end());
        if (!faces.emplace(key, face).second) faces.erase(key);
      }
    PolygonMesh mesh;
    mesh.positions = corners;
    for (const auto& [key, face] : faces) {
      mesh.face_sizes.push_back(3);
      mesh.indices.insert(mesh.indices.end(), face.begin(), face.end());
    }
    return mesh;
  }
};

namespace tetrahedra {

using Point = std::array<ExactFraction, 3>;
using Cell = std::array<Point, 4>;

inline ExactFraction six_volumes(const Point& a, const Point& b, const Point& c, const Point& d) {
  Point u, v, w;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// The part of a cell where six_volumes(p, q, r, _) is positive, as cells.
inline void clip(const Cell& cell, const Point& p, const Point& q, const Point& r,
                 std::vector<Cell>& parts) {
  std::array<ExactFraction, 4> side;
  std::vector<std::size_t> in, out;
  for (std::size_t k = 0; k < 4; ++k) {
    side[k] = six_volumes(p, q, r, cell[k]);
    (side[k] > 0 ? in : out).push_back(k);
  }
  const auto between = [&](std::size_t i, std::size_t o) {
    const ExactFraction t = side[i] / (side[i] - side[o]);
    Point point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = cell[i][k] + t * (cell[o][k] - cell[i][k]);
    return point;
  };
  const auto add_prism = [&](const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    parts.push_back({a[0], a[1], a[2], b[2]});
    parts.push_back({a[0], a[1], b[1], b[2]});
    parts.push_back({a[0], b[0], b[1], b[2]});
  };
  if (in.size() == 4) parts.push_back(cell);
  if (in.size() == 3)
    add_prism({cell[in[0]], cell[in[1]], cell[in[2]]},
              {between(in[0], out[0]), between(in[1], out[0]), between(in[2], out[0])});
  if (in.size() == 2)
    add_prism({cell[in[0]], between(in[0], out[0]), between(in[0], out[1])},
              {cell[in[1]], between(in[1], out[0]), between(in[1], out[1])});
  if (in.size() == 1)
    parts.push_back(
        {cell[in[0]], between(in[0], out[0]), between(in[0], out[1]), between(in[0], out[2])});
}

inline ExactFraction common_six_volumes(const Cell& s, const Cell& t) {
  std::vector<Cell> left{s}, next;
  for (const auto& [a, b, c] :
       {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    next.clear();
    // The faces are seen from outside; inside, the volume is negative.
    for (const Cell& cell : left) clip(cell, t[a], t[c], t[b], next);
    left.swap(next);
  }
  ExactFraction sum = 0;
  for (const Cell& cell : left) sum += abs(six_volumes(cell[0], cell[1], cell[2], cell[3]));
  return sum;
}

inline std::vector<Cell> cells_of(const Tetrahedra& solid) {
  std::vector<Cell> cells;
  for (const auto& corners : solid.cells) {
    Cell cell;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3& p = solid.corners[corners[k]];
      cell[k] = {ExactFraction(p.x), ExactFraction(p.y), ExactFraction(p.z)};
    }
    cells.push_back(cell);
  }
  return cells;
}

inline bool boxes_are_apart(const Cell& s, const Cell& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto low = [&](const Cell& c) { return std::min({c[0][k], c[1][k], c[2][k], c[3][k]}); };
    const auto high = [&](const Cell& c) { return std::max({c[0][k], c[1][k], c[2][k], c[3][k]}); };
    if (low(s) >= high(t) || low(t) >= high(s)) return true;
  }
  return false;
}

}  // namespace tetrahedra

inline ExactFraction exact_volume(const Tetrahedra& solid) {
  ExactFraction sum = 0;
  for (const auto& c : tetrahedra::cells_of(solid))
    sum += tetrahedra::six_volumes(c[0], c[1], c[2], c[3]);
  return sum / 6;
}

inline ExactFraction exact_common_volume(const Tetrahedra& a, const Tetrahedra& b) {
  const auto cells_a = tetrahedra::cells_of(a), cells_b = tetrahedra::cells_of(b);
  ExactFraction sum = 0;
  for (const auto& s : cells_a)
    for (const auto& t : cells_b)
      if (!tetrahedra::boxes_are_apart(s, t)) sum += tetrahedra::common_six_volumes(s, t);
  return sum / 6;
}

}  // namespace sectile::test
