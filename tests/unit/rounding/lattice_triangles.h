// Triangles whose corners have integer coordinates, and what they have in common: exactly.
#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace sectile::lattice {

using Point = std::array<std::int64_t, 3>;
using Corners = std::array<Point, 3>;

inline std::int64_t volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::int64_t u[3], v[3], w[3];
  for (std::size_t k = 0; k < 3; ++k) u[k] = a[k] - d[k], v[k] = b[k] - d[k], w[k] = c[k] - d[k];
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

inline int sign(std::int64_t value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// On which side of the edge from p to q, in the plane of a triangle with this normal?
inline int beside(const Point& p, const Point& q, const Point& at, const Point& normal) {
  Point u, v;
  for (std::size_t k = 0; k < 3; ++k) u[k] = q[k] - p[k], v[k] = at[k] - p[k];
  return sign(normal[0] * (u[1] * v[2] - u[2] * v[1]) + normal[1] * (u[2] * v[0] - u[0] * v[2]) +
              normal[2] * (u[0] * v[1] - u[1] * v[0]));
}

inline Point normal_of(const Corners& t) {
  Point u, v;
  for (std::size_t k = 0; k < 3; ++k) u[k] = t[1][k] - t[0][k], v[k] = t[2][k] - t[0][k];
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Has the segment, but for its ends that are corners of the triangle, a point in it?
inline bool meets(const Point& from, const Point& to, const Corners& t) {
  const auto is_corner = [&](const Point& p) { return p == t[0] || p == t[1] || p == t[2]; };
  const int a = sign(volume(t[0], t[1], t[2], from)), b = sign(volume(t[0], t[1], t[2], to));
  if (a * b > 0) return false;
  const Point n = normal_of(t);
  if (a == 0 && b == 0) {  // in its plane: beyond an edge, or all of it on one side of both ends
    if (is_corner(from) && is_corner(to)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &p = t[i], &q = t[(i + 1) % 3];
      const int f = beside(p, q, from, n), g = beside(p, q, to, n);
      if ((f < 0 && (g < 0 || (g == 0 && is_corner(to)))) || (g < 0 && f == 0 && is_corner(from)))
        return false;
    }
    int left = 0, right = 0, on = 0;
    for (const Point& c : t) {
      const int s = beside(from, to, c, n);
      left += s > 0;
      right += s < 0;
      on += s == 0 && c != from && c != to;
    }
    return (left > 0 && right > 0) || on > 0;
  }
  if ((a == 0 && is_corner(from)) || (b == 0 && is_corner(to))) return false;
  // Where it crosses the plane: on which side of each edge?
  int inside = 0, outside = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int s = sign(volume(from, to, t[i], t[(i + 1) % 3]));
    inside += s > 0;
    outside += s < 0;
  }
  return inside == 0 || outside == 0;
}

inline bool meet_in_more(const Corners& s, const Corners& t) {
  for (std::size_t i = 0; i < 3; ++i)
    if (meets(s[i], s[(i + 1) % 3], t) || meets(t[i], t[(i + 1) % 3], s)) return true;
  return false;
}

class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : random_(seed) {}

  /// From -size to size.
  std::int64_t number(std::int64_t size) {
    return std::uniform_int_distribution<std::int64_t>(-size, size)(random_);
  }
  Point point(std::int64_t size) { return {number(size), number(size), number(size)}; }

 private:
  std::mt19937_64 random_;
};

}  // namespace sectile::lattice
