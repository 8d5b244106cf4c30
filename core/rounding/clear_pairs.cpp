#include "rounding/clear_pairs.h"

#include <algorithm>
#include <cmath>

#include "geometry/axes.h"
#include "rounding/triangle_corners.h"

namespace sectile {
namespace {

// From one point to another, seen against an axis.
struct Way {
  double u, v;
  Way(const Vec3& from, const Vec3& to, int axis)
      : u(component(to, next_axis(axis)) - component(from, next_axis(axis))),
        v(component(to, next_next_axis(axis)) - component(from, next_next_axis(axis))) {}
  double reach() const { return std::max(std::abs(u), std::abs(v)); }
};

// Which way did b always lead away from a, to the left or to the right? Zero if doubles do not
// tell.
Sign clear_turn(const Way& a, const Way& b, double slack) {
  const double left = a.u * b.v, right = a.v * b.u, size = std::abs(left) + std::abs(right);
  // Each of four factors was off by two slacks at the most.
  const double off = 4 * slack * (a.reach() + b.reach() + 4 * slack);
  // Three roundings of half an ulp in each product, and one of the difference. Underflow of
  // products is nothing beside a size of that order.
  if (size > 0x1p-700 && size < 0x1p700 &&
      std::abs(left - right) > 8 * 0x1p-53 * size + (1 + 0x1p-40) * off)
    return sign_of(left - right);
  return Sign::zero;
}
Sign clear_turn(const Vec3& p, const Vec3& q, const Vec3& r, int axis, double slack) {
  return clear_turn(Way(p, q, axis), Way(p, r, axis), slack);
}

// An edge seen against an axis, for several corners: clear_turn with what they have in common.
class SeenEdge {
 public:
  SeenEdge(const Vec3& from, const Vec3& to, int axis, double slack)
      : from_(from),
        edge_(from, to, axis),
        axis_(axis),
        off_((1 + 0x1p-40) * 4 * slack * (edge_.reach() + 4 * slack)),
        off_with_reach_(8 * 0x1p-53 * (std::abs(edge_.u) + std::abs(edge_.v)) +
                        (1 + 0x1p-40) * 4 * slack) {}

  /// Did the edge certainly always turn that way to a corner?
  bool turns(Sign way, const Vec3& to) const {
    const Way other(from_, to, axis_);
    const double turn = edge_.u * other.v - other.u * edge_.v, reach = other.reach(),
                 off = off_ + off_with_reach_ * reach;
    // Underflow of products is nothing beside numbers of that order.
    return reach < 0x1p400 && off > 0x1p-700 && (way == Sign::positive ? turn > off : -turn > off);
  }

 private:
  Vec3 from_;
  Way edge_;
  int axis_;
  double off_, off_with_reach_;
};

// Seen along the axis, is the other triangle beyond one of the edges of a triangle?
bool beyond_an_edge(const PlacedTriangle& s, Sign turn, int axis, const PlacedTriangle& t,
                    double slack) {
  if (turn == Sign::zero) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const SeenEdge edge(s.at[i], s.at[next_corner(i)], axis, slack);
    if (edge.turns(-turn, t.at[0]) && edge.turns(-turn, t.at[1]) && edge.turns(-turn, t.at[2]))
      return true;
  }
  return false;
}

// Are the corners of t, but those of s, clearly on one side of the plane of s?
bool beside_plane(const ViewedTriangle& s, const PlacedTriangle& t) {
  Sign side = Sign::zero;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign here = s.plane.clear_side(t.at[i]);
    if (here == Sign::zero) {
      const std::uint32_t v = t.vertex[i];
      const auto& own = s.placed.vertex;
      if (v != own[0] && v != own[1] && v != own[2]) return false;
    } else if (side == Sign::zero) {
      side = here;
    } else if (side != here) {
      return false;
    }
  }
  return side != Sign::zero;
}

// Does a plane through an edge of s and a corner of t have the rest of them on its two sides?
bool apart_by_edge_and_corner(const PlacedTriangle& s, const PlacedTriangle& t, double slack) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const PlaneWithSlack plane(s.at[i], s.at[next_corner(i)], t.at[j], slack);
      const Sign side = plane.clear_side(s.at[previous_corner(i)]);
      if (side != Sign::zero && plane.clear_side(t.at[next_corner(j)]) == -side &&
          plane.clear_side(t.at[previous_corner(j)]) == -side)
        return true;
    }
  return false;
}

// Neither lies beside the plane of the other.
bool clearly_apart(const PlacedTriangle& s, const TriangleView& view, const PlacedTriangle& t,
                   double slack) {
  const Sign turn = clear_turn(t.at[0], t.at[1], t.at[2], view.axis, slack);
  return beyond_an_edge(s, view.turn, view.axis, t, slack) ||
         beyond_an_edge(t, turn, view.axis, s, slack) || apart_by_edge_and_corner(s, t, slack) ||
         apart_by_edge_and_corner(t, s, slack);
}

// Does the plane through v and two others have two more on its two sides?
bool between(const Vec3& v, const Vec3& p, const Vec3& q, const Vec3& beside_p,
             const Vec3& beside_q, double slack) {
  const PlaneWithSlack plane(v, p, q, slack);
  const Sign side = plane.clear_side(beside_p);
  return side != Sign::zero && plane.clear_side(beside_q) == -side;
}

// Was a point always ahead of another one in a direction, or behind it? Zero if doubles do not
// tell.
Sign clearly_ahead(const Vec3& n, const Vec3& from, const Vec3& to, double slack) {
  const double x = n.x * (to.x - from.x), y = n.y * (to.y - from.y), z = n.z * (to.z - from.z),
               size = std::abs(x) + std::abs(y) + std::abs(z), sum = x + y + z;
  const double off = 2 * slack * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  // Two roundings of half an ulp in each product, and two of sums.
  if (size > 0x1p-700 && size < 0x1p700 && std::abs(sum) > 8 * 0x1p-53 * size + (1 + 0x1p-40) * off)
    return sign_of(sum);
  return Sign::zero;
}

// Does the plane through v across the way from one to the other have them on its two sides?
bool opposite(const Vec3& v, const Vec3& s1, const Vec3& s2, const Vec3& t1, const Vec3& t2,
              double slack) {
  const Vec3 n{(s1.x - t1.x) + (s2.x - t2.x), (s1.y - t1.y) + (s2.y - t2.y),
               (s1.z - t1.z) + (s2.z - t2.z)};
  return clearly_ahead(n, v, s1, slack) == Sign::positive &&
         clearly_ahead(n, v, s2, slack) == Sign::positive &&
         clearly_ahead(n, v, t1, slack) == Sign::negative &&
         clearly_ahead(n, v, t2, slack) == Sign::negative;
}

// Corner i of s is corner j of t, and neither lies beside the plane of the other. Another plane
// through it has one of them on each side: across the way between them, or seen along the axis as a
// line through an edge, or through an edge of each.
bool clear_at_corner(const PlacedTriangle& s, std::size_t i, const TriangleView& view,
                     const PlacedTriangle& t, std::size_t j, double slack) {
  const Vec3 &v = s.at[i], &s1 = s.at[next_corner(i)], &s2 = s.at[previous_corner(i)],
             &t1 = t.at[next_corner(j)], &t2 = t.at[previous_corner(j)];
  if (opposite(v, s1, s2, t1, t2, slack)) return true;
  const Way to_s1(v, s1, view.axis), to_s2(v, s2, view.axis), to_t1(v, t1, view.axis),
      to_t2(v, t2, view.axis);
  const Sign own = view.turn, other = clear_turn(to_t1, to_t2, slack);
  const Sign first = clear_turn(to_s1, to_t1, slack), second = clear_turn(to_s1, to_t2, slack),
             third = clear_turn(to_s2, to_t1, slack), fourth = clear_turn(to_s2, to_t2, slack);
  if ((first == -own && second == -own) || (third == own && fourth == own)) return true;
  if (other != Sign::zero &&
      ((first == other && third == other) || (second == -other && fourth == -other)))
    return true;
  return between(v, s1, t1, s2, t2, slack) || between(v, s1, t2, s2, t1, slack) ||
         between(v, s2, t1, s1, t2, slack) || between(v, s2, t2, s1, t1, slack);
}

// Edge i of s is an edge of t, whose third corner is `far`, and may be in the plane of s.
bool clear_at_edge(const PlacedTriangle& s, std::size_t i, const TriangleView& view,
                   const Vec3& far, double slack) {
  return clear_turn(s.at[i], s.at[next_corner(i)], far, view.axis, slack) == -view.turn;
}

TriangleView clear_view(const PlacedTriangle& triangle, const std::array<double, 3>& normal,
                        double slack) {
  const auto& [a, b, c] = triangle.at;
  const int axis = main_axis(normal);
  const Sign turn = clear_turn(a, b, c, axis, slack);
  return turn == Sign::zero ? TriangleView() : TriangleView{axis, turn};
}

}  // namespace

Box box_around(const PlacedTriangle& triangle, double wider) {
  Bounds bounds;
  for (const Vec3& p : triangle.at) bounds.add(p);
  bounds.low = {bounds.low.x - wider, bounds.low.y - wider, bounds.low.z - wider};
  bounds.high = {bounds.high.x + wider, bounds.high.y + wider, bounds.high.z + wider};
  return bounds.box();
}

// The volume is a sum of six products of three differences. Each was off by two slacks at the most.
// The roundings are those of NormalOfThree::clear_side, less than nine.
PlaneWithSlack::PlaneWithSlack(const Vec3& a, const Vec3& b, const Vec3& c, double slack)
    : corner_(a) {
  const NormalOfThree three(a, b, c);
  normal_ = three.normal;
  const double span = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(b.z - a.z),
                                std::abs(c.x - a.x), std::abs(c.y - a.y), std::abs(c.z - a.z)}) +
                      2 * slack;
  const double moved = 24 * slack * span;
  off_ = (1 + 0x1p-40) * (12 * slack * span * span + 2 * slack * moved);
  off_with_reach_ =
      (1 + 0x1p-40) * (9 * 0x1p-53 * (three.size[0] + three.size[1] + three.size[2]) + moved);
}

ViewedTriangle::ViewedTriangle(const PlacedTriangle& triangle, double slack)
    : placed(triangle),
      plane(triangle.at[0], triangle.at[1], triangle.at[2], slack),
      view(clear_view(triangle, plane.normal(), slack)) {}

bool clearly_meet_in_corners(const ViewedTriangle& s, const ViewedTriangle& t, double slack) {
  const std::array<std::uint32_t, 3>&in_s = s.placed.vertex, &in_t = t.placed.vertex;
  if (in_t[0] == in_t[1] || in_t[1] == in_t[2] || in_t[2] == in_t[0]) return false;
  if (beside_plane(s, t.placed) || beside_plane(t, s.placed)) return true;
  std::size_t common = 0, of_s = 0, of_t = 0;  // the sum of their numbers
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (in_s[i] == in_t[j]) {
        ++common;
        of_s += i;
        of_t += j;
      }
  switch (common) {
    case 0:
      return clearly_apart(s.placed, s.view, t.placed, slack);
    case 1:
      return clear_at_corner(s.placed, of_s, s.view, t.placed, of_t, slack);
    case 2:  // the third corners have what is missing to 0 + 1 + 2
      return clear_at_edge(s.placed, next_corner(3 - of_s), s.view, t.placed.at[3 - of_t], slack);
    default:
      return false;
  }
}

}  // namespace sectile
