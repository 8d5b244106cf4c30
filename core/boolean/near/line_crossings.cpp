#include "boolean/near/line_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/probe.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

class CrossingsFinder {
 public:
  CrossingsFinder(const Kernel& kernel, const SpineLines& lines,
                  std::span<const PlanesOfLine> planes)
      : kernel_(kernel), lines_(lines), planes_(planes) {}

  std::vector<LineCrossing> run() {
    std::vector<PieceTree::Edge> edges;
    for (std::uint32_t line = 0; line < lines_.count(); ++line) {
      const auto [from, to] = ends(line);
      edges.push_back({at(from), at(to)});
    }
    std::vector<LineCrossing> found;
    PieceTree(edges).self_overlaps([&](std::uint32_t i, std::uint32_t j) {
      if (!planes_[i].second.valid() || !planes_[j].second.valid()) return;
      if (const auto place = crossing(i, j))
        found.push_back({{i, j}, *place, {far_end(j, *place), far_end(i, *place)}});
    });
    return found;
  }

 private:
  const Vec3& at(PointId p) const { return kernel_.geometry().position(p); }
  std::pair<PointId, PointId> ends(std::uint32_t line) const {
    const auto [from, to] = lines_.extent(line);
    return {PointId(from), PointId(to)};
  }

  std::optional<Vec3> crossing(std::uint32_t line, std::uint32_t other) const {
    const auto [first, second] = planes_[other];
    const auto [from, to] = ends(line);
    const bool in_first =
        kernel_.side(from, first) == Sign::zero && kernel_.side(to, first) == Sign::zero;
    const auto crossed = where_crossed(line, in_first ? second : first);
    if (!crossed || crossed->side(in_first ? first : second) != Sign::zero ||
        !is_between_ends(*crossed, other))
      return {};
    return crossed->position();
  }

  // By a plane in which it is not.
  std::optional<Probe> where_crossed(std::uint32_t line, PlaneId plane) const {
    const auto [from, to] = ends(line);
    const Sign first = kernel_.side(from, plane), last = kernel_.side(to, plane);
    if (first == Sign::zero) return Probe(kernel_, from);
    if (last == Sign::zero) return Probe(kernel_, to);
    if (first == last) return {};
    return Probe(kernel_, from, to, {planes_[line].first, planes_[line].second, plane, {}, {}});
  }

  // Of a point on a line.
  bool is_between_ends(const Probe& p, std::uint32_t line) const {
    const auto [from, to] = ends(line);
    for (int axis = 0; axis < 3; ++axis) {
      const Sign way = kernel_.compare(from, to, axis);
      if (way != Sign::zero) return p.compare(from, axis) != way && p.compare(to, axis) != -way;
    }
    return false;
  }

  Vec3 far_end(std::uint32_t line, const Vec3& place) const {
    const auto way = [&](PointId end) {
      const Vec3& p = at(end);
      return std::abs(p.x - place.x) + std::abs(p.y - place.y) + std::abs(p.z - place.z);
    };
    const auto [from, to] = ends(line);
    return at(way(from) > way(to) ? from : to);
  }

  const Kernel& kernel_;
  const SpineLines& lines_;
  std::span<const PlanesOfLine> planes_;
};

}  // namespace

std::vector<LineCrossing> line_crossings(const Kernel& kernel, const SpineLines& lines,
                                         std::span<const PlanesOfLine> planes) {
  return CrossingsFinder(kernel, lines, planes).run();
}

// What is beside its own line is on one side of the plane of both lines, or the face is on both.
void LeavingCrossing::add_corner(const Vec3& place, const std::array<bool, 2>& is_on_line) {
  for (const unsigned k : {0u, 1u}) {
    if (is_on_line[k]) continue;
    const auto [by, error] = lines_[crossing_.line[k]].turned(crossing_.ahead[k], place);
    turned_[k].add(by - error, by + error);
  }
  if (is_on_line[own_]) return;
  const Sign side =
      is_on_line[1 - own_] ? Sign::zero : lines_[crossing_.line[0]].turn(crossing_.ahead[0], place);
  side_.add(side == Sign::positive ? 1 : -1, side == Sign::negative ? -1 : 1);
}

// Seen along a line, what a face covers is between its corners. In the plane of both lines, a face
// on one side has nothing but what is on its own line.
Box LeavingCrossing::box() const {
  Bounds bounds;
  const bool on_one_side = side_.low == side_.high;
  for (const Range& turned : turned_)
    if (!on_one_side || turned.low > turned.high) {
      bounds.add({-1, -1, -1});
      bounds.add({1, 1, 1});
      return bounds.box();
    }
  bounds.add({turned_[0].low, turned_[1].low, side_.low});
  bounds.add({turned_[0].high, turned_[1].high, side_.high});
  return bounds.box();
}

}  // namespace sectile
