#include "selftest/edges_on_line.h"

#include <algorithm>

#include "selftest/wedge_order.h"

namespace sectile {
namespace {

int axis_of_line(const Kernel& kernel, std::span<const PointId> points) {
  for (const PointId p : points)
    for (int axis = 0; axis < 3; ++axis)
      if (kernel.compare(points[0], p, axis) != Sign::zero) return axis;
  return 0;
}

// Around a stretch with these sides, two for each edge: are the two of each neighbours?
bool are_in_pairs(std::span<const SideOfLine> sides) {
  for (const std::size_t first : {std::size_t(0), std::size_t(1)}) {
    bool all = true;
    for (std::size_t i = first; i < sides.size() && all; i += 2)
      all = sides[i].number == sides[(i + 1) % sides.size()].number;
    if (all) return true;
  }
  return false;
}

}  // namespace

EdgesOnLine::EdgesOnLine(const TriangleSurface& surface, const Kernel& kernel,
                         std::span<const std::uint32_t> triangles, std::span<const PointId> points)
    : surface_(surface),
      kernel_(kernel),
      points_(points),
      axis_(axis_of_line(kernel, points)),
      places_(points.begin(), points.end()) {
  std::ranges::sort(places_, [&](PointId p, PointId q) {
    const Sign up = kernel.compare(p, q, axis_);
    return up != Sign::zero ? up == Sign::positive : p < q;
  });
  const auto again = std::ranges::unique(
      places_, [&](PointId p, PointId q) { return kernel.compare(p, q, axis_) == Sign::zero; });
  places_.erase(again.begin(), again.end());
  find_edges(triangles);
}

void EdgesOnLine::find_edges(std::span<const std::uint32_t> triangles) {
  for (const std::uint32_t t : triangles) {
    if (is_ignored(t)) continue;
    for (unsigned k = 0; k < 3; ++k) {
      const PointId from = surface_.corners[t][k], to = surface_.corners[t][k < 2 ? k + 1 : 0];
      if (!std::ranges::binary_search(points_, from) || !std::ranges::binary_search(points_, to))
        continue;
      const std::uint32_t mate = surface_.mate[t][k];
      divided_ |= (mate & TriangleSurface::partial) != 0;
      const std::uint32_t across = surface_.neighbour(t, static_cast<int>(k));
      const std::size_t p = place_of(from), q = place_of(to);
      edges_.push_back({t, across, p < q, std::min(p, q), std::max(p, q)});
    }
  }
  // As a rule, they are known from both sides.
  const auto sides = [](const Edge& e) {
    return std::pair(std::min(e.triangle, e.across), std::max(e.triangle, e.across));
  };
  std::ranges::sort(edges_, {}, [&](const Edge& e) { return std::pair(sides(e), e.triangle); });
  const auto again = std::ranges::unique(edges_, {}, sides);
  edges_.erase(again.begin(), again.end());
}

std::size_t EdgesOnLine::place_of(PointId p) const {
  return static_cast<std::size_t>(std::partition_point(places_.begin(), places_.end(),
                                                       [&](PointId q) {
                                                         return kernel_.compare(q, p, axis_) ==
                                                                Sign::positive;
                                                       }) -
                                  places_.begin());
}

bool EdgesOnLine::alternate() const {
  if (divided_) return false;
  for (std::size_t i = 0; i + 1 < places_.size(); ++i)
    if (!alternate_between(i, i + 1)) return false;
  return true;
}

bool EdgesOnLine::alternate_between(std::size_t low, std::size_t high) const {
  std::vector<SideOfLine> sides;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    if (e.low > low || e.high < high) continue;
    sides.push_back({surface_.plane[e.triangle], e.up, i});
    sides.push_back({surface_.plane[e.across], !e.up, i});
  }
  return sides.size() <= 2 || (sort_around(kernel_, axis_, sides) && are_in_pairs(sides));
}

}  // namespace sectile
