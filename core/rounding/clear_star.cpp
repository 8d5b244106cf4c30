#include "rounding/clear_star.h"

#include <algorithm>
#include <cmath>

namespace sectile {
namespace {

using Direction = Facing::Direction;

double reach_of(const Direction& d) {
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}

void add(Direction& sum, double weight, const Direction& d) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * d[k];
}

// All triangles turn left seen from here. So they do all the way, by less than half a turn each,
// and how often they go around the vertex is always the same: as often as they get from behind a
// plane through the vertex and the direction to before it. If that is once, no two are in one
// place.
bool go_around_once(const Vec3& vertex, std::span<const StarTriangle> triangles,
                    const Direction& from, double reach) {
  constexpr Direction any{0.37, 0.59, 0.73};
  const Direction across{from[1] * any[2] - from[2] * any[1], from[2] * any[0] - from[0] * any[2],
                         from[0] * any[1] - from[1] * any[0]};
  // Each coordinate of it is off by three roundings of half an ulp of what is summed up, twice the
  // reach at most; and each term of the sums below by three more.
  const double off = 0x1p-46 * reach;
  bool is_certain = true;
  const auto is_before = [&](const Vec3& p) {
    const Direction way{p.x - vertex.x, p.y - vertex.y, p.z - vertex.z};
    const double value = across[0] * way[0] + across[1] * way[1] + across[2] * way[2],
                 least = off * reach_of(way);
    // Underflow of products is nothing beside numbers of that order.
    is_certain &= least > 0x1p-750 && std::abs(value) > least;
    return value > 0;
  };
  int times = 0;
  for (const StarTriangle& t : triangles)
    times += !is_before(t.first) && is_before(t.second) ? 1 : 0;
  return is_certain && times == 1;
}

}  // namespace

Facing::Facing(const PlaneWithSlack& plane) {
  const double size = reach_of(plane.normal());
  // Underflow of products is nothing beside numbers of that order.
  if (!(plane.normal_off() > 0x1p-750 && size < 0x1p700)) return;
  for (std::size_t k = 0; k < 3; ++k) normal_[k] = plane.normal()[k] / size;
  // The quotients, and what is computed with them, are off by less than eight roundings of numbers
  // up to three times the reach of the direction.
  off_ = plane.normal_off() / size + 0x1p-48;
}

// From the side to which they look on the whole; then more from the sides of those that were not
// seen (F. Rosenblatt's perceptron finds one if there is any, and nearly always at once).
bool is_clear_star(const Vec3& vertex, std::span<const StarTriangle> triangles) {
  Direction from = {};
  for (const StarTriangle& t : triangles) add(from, 1, t.facing.normal());
  for (int tries = 0; tries < 4; ++tries) {
    const double reach = reach_of(from);
    Direction unseen = {};
    bool all = true;
    for (const StarTriangle& t : triangles) {
      if (t.facing.certainly(from, reach)) continue;
      all = false;
      add(unseen, 1, t.facing.normal());
    }
    if (all) return go_around_once(vertex, triangles, from, reach);
    if (reach_of(unseen) == 0) return false;
    add(from, reach / reach_of(unseen), unseen);
  }
  return false;
}

}  // namespace sectile
