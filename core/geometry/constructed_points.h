// Many constructed points for a geometry at once, on all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/geometry.h"
#include "geometry/kernel.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"

namespace sectile {

struct MadePoint {
  Construction how;
  ConstructedPoint point;
};

/// Adds the points that get(i) points to, for i = 0 … count - 1, unless it gives none, and calls
/// set(i, point) for each. They get the numbers that add_constructed() would give one by one.
template <class Get, class Set>
void add_constructed_points(Geometry& geometry, std::size_t count, const Get& get, const Set& set) {
  struct Counts {
    std::size_t points = 0, constructions = 0;
  };
  constexpr std::size_t part = threshold(4096, 4);
  std::vector<Counts> before((count + part - 1) / part);  // what is there before each part
  const auto for_each = [&](std::size_t p, const auto& visit) {
    for (std::size_t i = p * part; i < std::min(count, (p + 1) * part); ++i)
      if (const MadePoint* made = get(i)) visit(i, *made);
  };
  parallel::loop(0, before.size(), [&](std::size_t p) {
    for_each(p, [&](std::size_t, const MadePoint& made) {
      ++before[p].points;
      before[p].constructions += made.point.is_explicit ? 0 : 1;
    });
  });
  Counts all{geometry.positions.size(), geometry.constructions.size()};
  for (Counts& counts : before) {
    const Counts here = std::exchange(counts, all);
    all.points += here.points;
    all.constructions += here.constructions;
  }
  geometry.positions.resize_unwritten(all.points);
  geometry.construct.resize_unwritten(all.points);
  geometry.constructions.resize(all.constructions);
  parallel::loop(0, before.size(), [&](std::size_t p) {
    Counts next = before[p];
    for_each(p, [&](std::size_t i, const MadePoint& made) {
      const PointId id(next.points++);
      geometry.positions[id] = made.point.position;
      geometry.construct[id] = Geometry::explicit_point;
      if (!made.point.is_explicit) {
        geometry.construct[id] = static_cast<std::uint32_t>(next.constructions);
        geometry.constructions[next.constructions++] = made.how;
      }
      set(i, id);
    });
  });
}

}  // namespace sectile
