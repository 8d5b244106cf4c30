#include "rounding/line_separation.h"

#include <algorithm>
#include <cmath>

#include "numbers/threshold.h"
#include "rounding/numbers_in_cone.h"
#include "rounding/triangle_corners.h"
#include "search/approximate.h"
#include "search/places_on_line.h"

namespace sectile {
namespace {

using namespace approximate;

constexpr std::size_t many_corners = threshold(8, 1), many_wedges = threshold(16, 2);
// So many steps an end may go.
constexpr double farthest_steps = 0x1p14;
// Of a step, where numbers are very much nearer to each other than steps.
constexpr double smallest_part = 0x1p-30;

Vec3 of_unit_length(const Vec3& v) {
  return (1 / length(v)) * v;
}

}  // namespace

bool are_crowded(std::span<const CornerOnEdge> on_edges) {
  std::size_t edges = 0;
  for (std::size_t i = 0; i < on_edges.size(); ++i)
    if (i == 0 || on_edges[i].edge != on_edges[i - 1].edge) ++edges;
  return edges > 0 && on_edges.size() >= many_corners * edges;
}

void LineSeparation::run(std::span<const CornerOnEdge> on_edges) {
  std::vector<PointId> points;
  for (const auto& [edge, corner] : on_edges)
    points.insert(points.end(), {PointId(edge.from), PointId(edge.to), corner});
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::vector<Side> edges = edges_between(points);
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (i == 0 || edges[i].edge != edges[i - 1].edge) pairs.push_back(edges[i].edge);
  for (const EdgesOfLine& line : edges_by_line(kernel_, points, pairs))
    if (line.edges.size() >= many_wedges) separate(line, points, edges);
  std::ranges::sort(separated_, {}, &Separated::point);
}

// Numbers of points among some, each edge as both its triangles have it.
std::vector<LineSeparation::Side> LineSeparation::edges_between(
    std::span<const PointId> points) const {
  const auto number = [&](PointId p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, p) - points.begin());
  };
  const auto is_one = [&](PointId p) { return std::ranges::binary_search(points, p); };
  std::vector<Side> edges;
  for (std::uint32_t t = 0; t < surface_.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PointId from = surface_.corners[t][k], to = surface_.corners[t][next_corner(k)];
      if (is_one(from) && is_one(to))
        edges.push_back({PointPair::between(number(from), number(to)), t, k});
    }
  std::ranges::stable_sort(edges, {}, &Side::edge);
  return edges;
}

EdgeSectors::Side LineSeparation::side(std::uint32_t t, std::size_t k) const {
  return {t, surface_.plane[t], surface_.corners[t][previous_corner(k)]};
}

// The same edge, as the triangle beyond it has it.
LineSeparation::Corner LineSeparation::mate(Corner corner) const {
  const std::uint32_t beyond = surface_.mate[corner.triangle][corner.k];
  const PointId from = surface_.corners[corner.triangle][next_corner(corner.k)];
  const auto& corners = surface_.corners[beyond];
  return {beyond, corners[0] == from ? 0u : corners[1] == from ? 1u : 2u};
}

void LineSeparation::separate(const EdgesOfLine& line, std::span<const PointId> points,
                              std::span<const Side> edges) {
  std::vector<PointId> on_line;
  for (const PointPair& e : line.edges)
    on_line.insert(on_line.end(), {points[e.from], points[e.to]});
  std::ranges::sort(on_line);
  on_line.erase(std::unique(on_line.begin(), on_line.end()), on_line.end());
  const PlacesOnLine places(kernel_, on_line);
  std::vector<EdgeSectors::Wedge> wedges;
  std::vector<Corner> rising;
  for (const PointPair& e : line.edges)
    for (auto edge = std::ranges::lower_bound(edges, e, {}, &Side::edge);
         edge != edges.end() && edge->edge == e; ++edge) {
      const Corner corner{edge->triangle, edge->k}, beyond = mate(corner);
      const auto& c = surface_.corners[corner.triangle];
      if (places.of(c[corner.k]) > places.of(c[next_corner(corner.k)])) continue;
      rising.push_back(corner);
      wedges.push_back({side(corner.triangle, corner.k), side(beyond.triangle, beyond.k)});
    }
  const EdgeSectors sectors(places.at(0), places.at(places.count() - 1), wedges, geometry_,
                            kernel_);
  std::vector<End> ends;
  const std::span<const std::uint32_t> order = sectors.order();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<PlaneId>& sector = sectors.of_wedge(i).planes;
    const Corner low = rising[order[i]], high = mate(low);
    if (sector.empty() || !add_end(low, on_line, wedges[order[i]], sector, ends) ||
        !add_end(high, on_line, wedges[order[i]], sector, ends) ||
        ends.back().to == ends[ends.size() - 2].to)
      return;
  }
  for (const End& end : ends) {
    const PointId to = geometry_.add_point(end.to);
    separated_.push_back({to, end.from});
    for (const auto& [t, k] : end.corners) surface_.corners[t][k] = to;
  }
  kernel_.refresh();
}

// The triangles around a corner, of which one edge is on the line.
bool LineSeparation::add_end(Corner corner, std::span<const PointId> on_line,
                             const EdgeSectors::Wedge& wedge, std::span<const PlaneId> sector,
                             std::vector<End>& ends) {
  End end{{}, surface_.corners[corner.triangle][corner.k], {}};
  const PointId other = surface_.corners[corner.triangle][next_corner(corner.k)];
  Corner next = corner;
  do {
    end.corners.push_back(next);
    const PointId beside = surface_.corners[next.triangle][next_corner(next.k)];
    if (beside != other) {
      if (std::ranges::binary_search(on_line, beside)) return false;
      for (const PlaneId plane : sector)
        if (kernel_.side(beside, plane) == Sign::positive) return false;
    }
    // On to the triangle beyond the edge that leads to the corner.
    next = mate({next.triangle, static_cast<std::uint32_t>(previous_corner(next.k))});
  } while (next.triangle != corner.triangle || next.k != corner.k);
  if (!find_place(end, wedge, sector)) return false;
  ends.push_back(std::move(end));
  return true;
}

// Beside the origin, steps are as small as numbers can be.
double LineSeparation::step_around(const End& end) const {
  double step = 0;
  for (const auto& [t, k] : end.corners)
    for (const PointId p : surface_.corners[t])
      step = std::max(step, grid_.step(geometry_.position(p)));
  return step;
}

bool LineSeparation::find_place(End& end, const EdgeSectors::Wedge& wedge,
                                std::span<const PlaneId> sector) {
  const Vec3& exact = geometry_.position(end.from);
  const Vec3 along = of_unit_length(
      geometry_.position(surface_.corners[end.corners[0].triangle][next_corner(end.corners[0].k)]) -
      exact);
  const auto across = [&](PointId p) {
    const Vec3 way = geometry_.position(p) - exact;
    return of_unit_length(way - dot(way, along) * along);
  };
  ThinCone cone;
  cone.tip = grid_.nearest(exact);
  cone.to_point = exact - cone.tip;
  cone.amid = of_unit_length(across(wedge.left.beside) + across(wedge.right.beside));
  for (const PlaneId plane : sector) {
    const auto& n = kernel_.value(plane).n;
    const double size = -std::hypot(n[0], n[1], n[2]);
    cone.inward.push_back({n[0] / size, n[1] / size, n[2] / size});
  }
  const double step = std::max(grid_.step(exact), smallest_part * step_around(end));
  for (double reach = 2; reach <= farthest_steps; reach *= 2)
    for (const Vec3& place :
         numbers_in_cone(grid_, cone, reach * step, smallest_part * reach * step)) {
      const PointId tried = geometry_.add_point(place);
      kernel_.refresh();
      end.to = place;
      if (std::ranges::all_of(
              sector, [&](PlaneId plane) { return kernel_.side(tried, plane) == Sign::negative; }))
        return true;
    }
  return false;
}

}  // namespace sectile
