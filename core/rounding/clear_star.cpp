#include "rounding/clear_star.h"

#include <algorithm>
#include <cmath>

namespace sectile {
namespace {

using Direction = Facing::Direction;

double reach_of(const Direction& d) {
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}
double scalar_product(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction vector_product(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Direction sum(const Direction& a, const Direction& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Direction minus(const Direction& a, const Direction& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// All triangles turn left seen from here. So they do all the way, by less than half a turn each,
// and how often they go around the vertex is always the same: as often as they get from behind a
// plane through the vertex and the direction to before it. If that is once, no two are in one
// place.
bool go_around_once(const Vec3& vertex, std::span<const StarTriangle> triangles,
                    const Direction& from) {
  constexpr Direction any{0.37, 0.59, 0.73};
  const Direction across = vector_product(from, any);
  // Each coordinate of it is off by three roundings of half an ulp of what is summed up, twice the
  // reach at most; and each term of the sums below by three more.
  const double off = 0x1p-46 * reach_of(from);
  bool is_certain = true;
  const auto is_before = [&](const Vec3& p) {
    const Direction way{p.x - vertex.x, p.y - vertex.y, p.z - vertex.z};
    const double value = scalar_product(across, way), least = off * reach_of(way);
    // Underflow of products is nothing beside numbers of that order.
    is_certain &= least > 0x1p-750 && std::abs(value) > least;
    return value > 0;
  };
  int times = 0;
  for (const StarTriangle& t : triangles)
    times += !is_before(t.first) && is_before(t.second) ? 1 : 0;
  return is_certain && times == 1;
}

bool are_all_seen(std::span<const StarTriangle> triangles, const Direction& from) {
  const double reach = reach_of(from);
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const StarTriangle& t) { return t.facing.certainly(from, reach); });
}

Direction least_seen(std::span<const StarTriangle> triangles, const Direction& from) {
  return std::min_element(triangles.begin(), triangles.end(),
                          [&](const StarTriangle& s, const StarTriangle& t) {
                            return scalar_product(s.facing.normal(), from) <
                                   scalar_product(t.facing.normal(), from);
                          })
      ->facing.normal();
}

}  // namespace

Facing::Facing(const PlaneWithSlack& plane) {
  const Direction& normal = plane.normal();
  const double reach = reach_of(normal);
  // Underflow of products is nothing beside numbers of that order.
  if (!(plane.normal_off() > 0x1p-750 && reach < 0x1p700)) return;
  const Direction scaled{normal[0] / reach, normal[1] / reach, normal[2] / reach};
  const double length = std::sqrt(scalar_product(scaled, scaled));
  for (std::size_t k = 0; k < 3; ++k) normal_[k] = scaled[k] / length;
  // The quotients, and what is computed with them, are off by less than a dozen roundings of
  // numbers up to three times the reach of the direction.
  off_ = plane.normal_off() / reach / length + 0x1p-47;
}

// As a rule they are seen from the side to which they look on the whole; along a sharp edge, from
// halfway between the two that look apart most; at a tip, from where three of them are seen alike.
bool is_clear_star(const Vec3& vertex, std::span<const StarTriangle> triangles) {
  Direction from = {};
  for (const StarTriangle& t : triangles) from = sum(from, t.facing.normal());
  if (are_all_seen(triangles, from)) return go_around_once(vertex, triangles, from);
  const Direction a = least_seen(triangles, from), b = least_seen(triangles, a);
  from = sum(a, b);
  if (are_all_seen(triangles, from)) return go_around_once(vertex, triangles, from);
  from = vector_product(minus(b, a), minus(least_seen(triangles, from), a));
  if (scalar_product(from, a) < 0) from = minus({}, from);
  return are_all_seen(triangles, from) && go_around_once(vertex, triangles, from);
}

}  // namespace sectile
