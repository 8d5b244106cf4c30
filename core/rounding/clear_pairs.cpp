#include "rounding/clear_pairs.h"

#include <cmath>

#include "geometry/axes.h"
#include "geometry/four_points.h"

namespace sectile {
namespace {

constexpr std::array<std::size_t, 3> after{1, 2, 0}, before{2, 0, 1};

// From one point to another, seen against an axis.
struct Way {
  double u, v;
  Way(const Vec3& from, const Vec3& to, int axis)
      : u(component(to, next_axis(axis)) - component(from, next_axis(axis))),
        v(component(to, next_next_axis(axis)) - component(from, next_next_axis(axis))) {}
};

// Which way does b lead away from a, to the left or to the right? Zero if doubles do not tell.
Sign clear_turn(const Way& a, const Way& b) {
  const double left = a.u * b.v, right = a.v * b.u, size = std::abs(left) + std::abs(right);
  // Three roundings of half an ulp in each product, and one of the difference. Underflow of
  // products is nothing beside a size of that order.
  if (size > 0x1p-700 && size < 0x1p700 && std::abs(left - right) > 8 * 0x1p-53 * size)
    return sign_of(left - right);
  return Sign::zero;
}
Sign clear_turn(const Vec3& p, const Vec3& q, const Vec3& r, int axis) {
  return clear_turn(Way(p, q, axis), Way(p, r, axis));
}

// Seen along the axis, is the other triangle beyond one of the edges of a triangle?
bool beyond_an_edge(const PlacedTriangle& s, Sign turn, int axis, const PlacedTriangle& t) {
  if (turn == Sign::zero) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& from = s.at[i];
    const Way edge(from, s.at[after[i]], axis);
    if (clear_turn(edge, Way(from, t.at[0], axis)) == -turn &&
        clear_turn(edge, Way(from, t.at[1], axis)) == -turn &&
        clear_turn(edge, Way(from, t.at[2], axis)) == -turn)
      return true;
  }
  return false;
}

bool on_one_side(const PlacedTriangle& s, const PlacedTriangle& t) {
  const Sign side = clear_side(s.at[0], s.at[1], s.at[2], t.at[0]);
  return side != Sign::zero && clear_side(s.at[0], s.at[1], s.at[2], t.at[1]) == side &&
         clear_side(s.at[0], s.at[1], s.at[2], t.at[2]) == side;
}

// Does a plane through an edge of s and a corner of t have the rest of them on its two sides?
bool apart_by_edge_and_corner(const PlacedTriangle& s, const PlacedTriangle& t) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 &from = s.at[i], &to = s.at[after[i]], &corner = t.at[j];
      const Sign side = clear_side(from, to, corner, s.at[before[i]]);
      if (side != Sign::zero && clear_side(from, to, corner, t.at[after[j]]) == -side &&
          clear_side(from, to, corner, t.at[before[j]]) == -side)
        return true;
    }
  return false;
}

bool clearly_apart(const PlacedTriangle& s, const TriangleView& view, const PlacedTriangle& t) {
  return beyond_an_edge(s, view.turn, view.axis, t) || on_one_side(s, t) || on_one_side(t, s) ||
         beyond_an_edge(t, clear_turn(t.at[0], t.at[1], t.at[2], view.axis), view.axis, s) ||
         apart_by_edge_and_corner(s, t) || apart_by_edge_and_corner(t, s);
}

// Does the plane through v and two others have two more on its two sides?
bool between(const Vec3& v, const Vec3& p, const Vec3& q, const Vec3& beside_p,
             const Vec3& beside_q) {
  const Sign side = clear_side(v, p, q, beside_p);
  return side != Sign::zero && clear_side(v, p, q, beside_q) == -side;
}

// Is a point ahead of another one in a direction, or behind it? Zero if doubles do not tell.
Sign clearly_ahead(const Vec3& n, const Vec3& from, const Vec3& to) {
  const double x = n.x * (to.x - from.x), y = n.y * (to.y - from.y), z = n.z * (to.z - from.z),
               size = std::abs(x) + std::abs(y) + std::abs(z), sum = x + y + z;
  // Two roundings of half an ulp in each product, and two of sums.
  if (size > 0x1p-700 && size < 0x1p700 && std::abs(sum) > 8 * 0x1p-53 * size) return sign_of(sum);
  return Sign::zero;
}

// Does the plane through v across the way from one to the other have them on its two sides?
bool opposite(const Vec3& v, const Vec3& s1, const Vec3& s2, const Vec3& t1, const Vec3& t2) {
  const Vec3 n{(s1.x - t1.x) + (s2.x - t2.x), (s1.y - t1.y) + (s2.y - t2.y),
               (s1.z - t1.z) + (s2.z - t2.z)};
  return clearly_ahead(n, v, s1) == Sign::positive && clearly_ahead(n, v, s2) == Sign::positive &&
         clearly_ahead(n, v, t1) == Sign::negative && clearly_ahead(n, v, t2) == Sign::negative;
}

// Corner i of s is corner j of t. A plane through it has one of them on each side: across the way
// between them, or seen along the axis as a line through an edge, or that of one of them, or
// through an edge of each.
bool clear_at_corner(const PlacedTriangle& s, std::size_t i, const TriangleView& view,
                     const PlacedTriangle& t, std::size_t j) {
  const Vec3 &v = s.at[i], &s1 = s.at[after[i]], &s2 = s.at[before[i]], &t1 = t.at[after[j]],
             &t2 = t.at[before[j]];
  if (opposite(v, s1, s2, t1, t2)) return true;
  const Way to_s1(v, s1, view.axis), to_s2(v, s2, view.axis), to_t1(v, t1, view.axis),
      to_t2(v, t2, view.axis);
  const Sign own = view.turn, other = clear_turn(to_t1, to_t2);
  const Sign first = clear_turn(to_s1, to_t1), second = clear_turn(to_s1, to_t2),
             third = clear_turn(to_s2, to_t1), fourth = clear_turn(to_s2, to_t2);
  if ((first == -own && second == -own) || (third == own && fourth == own)) return true;
  if (other != Sign::zero &&
      ((first == other && third == other) || (second == -other && fourth == -other)))
    return true;
  const Sign of_t = clear_side(v, s1, s2, t1), of_s = clear_side(v, t1, t2, s1);
  if ((of_t != Sign::zero && of_t == clear_side(v, s1, s2, t2)) ||
      (of_s != Sign::zero && of_s == clear_side(v, t1, t2, s2)))
    return true;
  return between(v, s1, t1, s2, t2) || between(v, s1, t2, s2, t1) || between(v, s2, t1, s1, t2) ||
         between(v, s2, t2, s1, t1);
}

// Edge i of s is an edge of t, whose third corner is `far`.
bool clear_at_edge(const PlacedTriangle& s, std::size_t i, const TriangleView& view,
                   const Vec3& far) {
  const Vec3 &from = s.at[i], &to = s.at[after[i]];
  return clear_turn(from, to, far, view.axis) == -view.turn ||
         clear_side(from, to, s.at[before[i]], far) != Sign::zero;
}

}  // namespace

TriangleView clear_view(const PlacedTriangle& triangle) {
  const auto& [a, b, c] = triangle.at;
  const double n[3] = {
      std::abs((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y)),
      std::abs((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)),
      std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)),
  };
  const int axis = n[0] >= n[1] ? (n[0] >= n[2] ? 0 : 2) : (n[1] >= n[2] ? 1 : 2);
  const Sign turn = clear_turn(a, b, c, axis);
  return turn == Sign::zero ? TriangleView() : TriangleView{axis, turn};
}

bool clearly_meet_in_corners(const PlacedTriangle& s, const TriangleView& view,
                             const PlacedTriangle& t) {
  if (t.vertex[0] == t.vertex[1] || t.vertex[1] == t.vertex[2] || t.vertex[2] == t.vertex[0])
    return false;
  std::size_t common = 0, in_s = 0, in_t = 0;  // the sum of their numbers
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (s.vertex[i] == t.vertex[j]) {
        ++common;
        in_s += i;
        in_t += j;
      }
  switch (common) {
    case 0:
      return clearly_apart(s, view, t);
    case 1:
      return clear_at_corner(s, in_s, view, t, in_t);
    case 2:  // the third corners have what is missing to 0 + 1 + 2
      return clear_at_edge(s, after[3 - in_s], view, t.at[3 - in_t]);
    default:
      return false;
  }
}

}  // namespace sectile
