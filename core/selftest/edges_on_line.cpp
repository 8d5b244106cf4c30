#include "selftest/edges_on_line.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace sectile {
namespace {

// The two sides of each edge that covers a stretch of the line, as one goes along it. Either all of
// them bound material, seen from one side to the other of an edge, or all the outside, unless
// there is one edge only.
class SidesAround {
 public:
  /// Two sides of an edge, by their places around the line. Returns false, and leaves all as it is,
  /// if they are not neighbours there, or what is around them does not alternate.
  bool add(std::uint32_t edge, std::uint32_t forward, std::uint32_t backward) {
    if (forward == backward || sides_.contains(forward) || sides_.contains(backward)) return false;
    if (!sides_.empty()) {
      const auto next = after(forward);
      if (next != after(backward)) return false;
      const auto last = before(next);
      const bool forward_is_first = is_first(last->first, forward, backward);
      if (forward_is_first == last->second.is_forward) return false;
      if (sides_.size() > 2 && last->second.edge == next->second.edge) return false;
    }
    sides_[forward] = {edge, true};
    sides_[backward] = {edge, false};
    return true;
  }
  void remove(std::uint32_t forward, std::uint32_t backward) {
    sides_.erase(forward);
    sides_.erase(backward);
  }

 private:
  struct Side {
    std::uint32_t edge;
    bool is_forward;
  };
  using Sides = std::map<std::uint32_t, Side>;  // by place

  Sides::const_iterator after(std::uint32_t place) const {
    const auto next = sides_.upper_bound(place);
    return next != sides_.end() ? next : sides_.begin();
  }
  Sides::const_iterator before(Sides::const_iterator side) const {
    return std::prev(side != sides_.begin() ? side : sides_.end());
  }
  // Counter-clockwise from a place.
  static bool is_first(std::uint32_t from, std::uint32_t place, std::uint32_t other) {
    return (place > from) == (other > from) ? place < other : place > from;
  }

  Sides sides_;
};

}  // namespace

EdgesOnLine::EdgesOnLine(const TriangleSurface& surface, const Kernel& kernel,
                         std::span<const std::uint32_t> triangles, std::span<const PointId> points)
    : surface_(surface), kernel_(kernel), points_(points), places_(kernel, points) {
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
      const std::size_t p = places_.of(from), q = places_.of(to);
      if (p != q) edges_.push_back({t, across, p < q, std::min(p, q), std::max(p, q)});
    }
  }
  // As a rule, they are known from both sides.
  const auto sides = [](const Edge& e) {
    return std::pair(std::min(e.triangle, e.across), std::max(e.triangle, e.across));
  };
  std::ranges::sort(edges_, {}, [&](const Edge& e) { return std::pair(sides(e), e.triangle); });
  const auto again = std::unique(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) {
    return sides(a) == sides(b);
  });
  edges_.erase(again, edges_.end());
}

std::vector<SideOfLine> EdgesOnLine::sides() const {
  std::vector<SideOfLine> sides;
  for (const Edge& e : edges_) {
    const PlaneId mine = surface_.plane[e.triangle], beyond = surface_.plane[e.across];
    sides.push_back({e.up ? mine : beyond, true});
    sides.push_back({e.up ? beyond : mine, false});
  }
  return sides;
}

// In each place, the edges that end there are gone before others begin.
bool EdgesOnLine::alternate() const {
  if (divided_) return false;
  const std::vector<std::uint32_t> at = places_around(kernel_, places_.axis(), sides());
  std::vector<std::uint32_t> beginning(edges_.size());
  std::iota(beginning.begin(), beginning.end(), 0u);
  std::vector<std::uint32_t> ending = beginning;
  std::ranges::sort(beginning, {}, [&](std::uint32_t e) { return edges_[e].low; });
  std::ranges::sort(ending, {}, [&](std::uint32_t e) { return edges_[e].high; });
  SidesAround around;
  auto ends = ending.begin();
  for (const std::uint32_t e : beginning) {
    for (; edges_[*ends].high <= edges_[e].low; ++ends)
      around.remove(at[2 * *ends], at[2 * *ends + 1]);
    if (!around.add(e, at[2 * e], at[2 * e + 1])) return false;
  }
  return true;
}

}  // namespace sectile
