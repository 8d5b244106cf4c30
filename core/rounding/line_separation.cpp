#include "rounding/line_separation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numbers/none.h"
#include "numbers/threshold.h"
#include "rounding/numbers_in_cone.h"
#include "rounding/triangle_corners.h"
#include "rounding/wedge_groups.h"
#include "search/approximate.h"

namespace sectile {
namespace {

using namespace approximate;

constexpr std::size_t many_corners = threshold(8, 1), many_wedges = threshold(16, 2);
// So many steps an end may go.
constexpr double farthest_steps = 0x1p14;
// Of a step, where numbers are very much nearer to each other than steps.
constexpr double smallest_part = 0x1p-30;

// So many steps from what rounding bends by less than one.
constexpr double clear_of_rounding = 2;
// So many faces around an end may have room below all of them.
constexpr std::size_t most_faces = 32;

Vec3 of_unit_length(const Vec3& v) {
  return (1 / length(v)) * v;
}

// Is a place so far below all planes of a cone?
bool is_clear(const ThinCone& cone, const Vec3& place, double distance) {
  const Vec3 way = place - cone.tip - cone.to_point;
  return distance == 0 || std::ranges::all_of(cone.inward, [&](const Vec3& inward) {
           return dot(inward, way) >= distance;
         });
}

// Numbers of stretches between two places each, by what they cover or touch together.
std::vector<std::vector<std::uint32_t>> coherent(
    std::span<const std::array<std::size_t, 2>> stretches) {
  std::vector<std::uint32_t> upwards(stretches.size());
  std::iota(upwards.begin(), upwards.end(), 0u);
  std::ranges::sort(upwards, {}, [&](std::uint32_t i) { return stretches[i]; });
  std::vector<std::vector<std::uint32_t>> pieces;
  std::size_t highest = 0;
  for (const std::uint32_t i : upwards) {
    const auto& [low, high] = stretches[i];
    if (pieces.empty() || low > highest) pieces.emplace_back();
    pieces.back().push_back(i);
    highest = std::max(highest, high);
  }
  return pieces;
}

}  // namespace

bool are_crowded(std::span<const CornerOnEdge> on_edges) {
  std::size_t edges = 0;
  for (std::size_t i = 0; i < on_edges.size(); ++i)
    if (i == 0 || on_edges[i].edge != on_edges[i - 1].edge) ++edges;
  return edges > 0 && on_edges.size() >= many_corners * edges;
}

void LineSeparation::run(std::span<const CornerOnEdge> on_edges) {
  find_points(on_edges);
  const std::vector<Side> edges = edges_between_points();
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (i == 0 || edges[i].edge != edges[i - 1].edge) pairs.push_back(edges[i].edge);
  for (const EdgesOfLine& line : edges_by_line(kernel_, points_, pairs)) {
    if (line.edges.size() < many_wedges) continue;
    const std::vector<PointId> on_line = points_on(line, on_edges);
    Book book = book_of(line, on_line, edges);
    separate(book, on_line);
  }
  std::ranges::sort(separated_, {}, &Separated::point);
}

void LineSeparation::find_points(std::span<const CornerOnEdge> on_edges) {
  for (const auto& [edge, corner] : on_edges)
    points_.insert(points_.end(), {PointId(edge.from), PointId(edge.to), corner});
  std::ranges::sort(points_);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  is_on_line_.assign(geometry_.positions.size(), false);
}

// Numbers of points, each edge as both its triangles have it.
std::vector<LineSeparation::Side> LineSeparation::edges_between_points() {
  corners_.assign(points_.size(), 0);
  std::vector<std::uint32_t> number(geometry_.positions.size(), none);
  for (std::uint32_t i = 0; i < points_.size(); ++i) number[points_[i].value()] = i;
  std::vector<Side> edges;
  for (std::uint32_t t = 0; t < surface_.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = number[surface_.corners[t][k].value()],
                          to = number[surface_.corners[t][next_corner(k)].value()];
      if (from == none) continue;
      ++corners_[from];
      if (to != none) edges.push_back({PointPair::between(from, to), t, k});
    }
  std::ranges::stable_sort(edges, {}, &Side::edge);
  return edges;
}

// The ends of its edges, and all corners on these.
std::vector<PointId> LineSeparation::points_on(const EdgesOfLine& line,
                                               std::span<const CornerOnEdge> on_edges) {
  std::vector<PointId> on_line;
  const auto add = [&](PointId p) {
    if (is_on_line_[p.value()]) return;
    is_on_line_[p.value()] = true;
    on_line.push_back(p);
  };
  for (const PointPair& e : line.edges) {
    const PointId from = points_[e.from], to = points_[e.to];
    add(from);
    add(to);
    const PointPair edge{from.value(), to.value()};
    for (auto on = std::ranges::lower_bound(on_edges, edge, {}, &CornerOnEdge::edge);
         on != on_edges.end() && on->edge == edge; ++on)
      add(on->corner);
  }
  for (const PointId p : on_line) is_on_line_[p.value()] = false;
  std::ranges::sort(on_line);
  return on_line;
}

// Edges of which another line has moved an end are not on this one any more.
LineSeparation::Book LineSeparation::book_of(const EdgesOfLine& line,
                                             std::span<const PointId> on_line,
                                             std::span<const Side> edges) const {
  Book book{PlacesOnLine(kernel_, on_line), {}, {}};
  for (const PointPair& e : line.edges)
    for (auto edge = std::ranges::lower_bound(edges, e, {}, &Side::edge);
         edge != edges.end() && edge->edge == e; ++edge) {
      const Corner corner{edge->triangle, edge->k};
      const PointId from = surface_.corners[corner.triangle][corner.k],
                    to = surface_.corners[corner.triangle][next_corner(corner.k)];
      if (PointPair::between(from.value(), to.value()) !=
              PointPair{points_[e.from].value(), points_[e.to].value()} ||
          book.places.of(from) > book.places.of(to))
        continue;
      book.wedges.push_back({side(corner), side(mate(corner))});
      book.ends.push_back({end_at(corner, on_line), end_at(mate(corner), on_line)});
    }
  return book;
}

EdgeSectors::Side LineSeparation::side(Corner corner) const {
  const auto [t, k] = corner;
  return {t, surface_.plane[t], surface_.corners[t][previous_corner(k)]};
}

// The same edge, as the triangle beyond it has it.
LineSeparation::Corner LineSeparation::mate(Corner corner) const {
  const std::uint32_t beyond = surface_.mate[corner.triangle][corner.k];
  const PointId from = surface_.corners[corner.triangle][next_corner(corner.k)];
  const auto& corners = surface_.corners[beyond];
  return {beyond, corners[0] == from ? 0u : corners[1] == from ? 1u : 2u};
}

// The triangles around a corner. One edge of them is on the line; where there are others, it stays.
LineSeparation::End LineSeparation::end_at(Corner corner, std::span<const PointId> on_line) const {
  End end{{}, surface_.corners[corner.triangle][corner.k], {}};
  const PointId other = surface_.corners[corner.triangle][next_corner(corner.k)];
  Corner next = corner;
  do {
    end.star.push_back(next);
    const PointId beside = surface_.corners[next.triangle][next_corner(next.k)];
    if (beside != other && std::ranges::binary_search(on_line, beside)) return {{}, end.from, {}};
    // On to the triangle beyond the edge that leads to the corner.
    next = mate({next.triangle, static_cast<std::uint32_t>(previous_corner(next.k))});
  } while (next.triangle != corner.triangle || next.k != corner.k);
  return end;
}

// What has both ends moved within its sector, or its material, meets nothing that it did not meet
// before. What has to stay on the line is bent by rounding: all beside it go so far that it cannot
// come to them.
void LineSeparation::separate(Book& book, std::span<const PointId> on_line) {
  const std::vector<bool> have_others = have_others_on_edges(book, on_line);
  const std::vector<std::vector<PlaneId>> sectors = sectors_of(book, have_others);
  std::vector<std::array<std::size_t, 2>> stretches;
  for (const auto& [low, high] : book.ends)
    stretches.push_back({book.places.of(low.from), book.places.of(high.from)});
  for (std::vector<std::uint32_t>& wedges : coherent(stretches)) {
    bool some_stay = false;
    const auto keep_those_with_places = [&] {
      return std::erase_if(wedges, [&](std::uint32_t i) {
        const double clearance = some_stay || have_others[i] ? clear_of_rounding : 0;
        return !find_places(book.ends[i], book.wedges[i], sectors[i], clearance);
      });
    };
    some_stay = keep_those_with_places() > 0;
    if (some_stay) keep_those_with_places();
    for (const std::uint32_t i : wedges) move(book.ends[i]);
  }
  kernel_.refresh();
}

void LineSeparation::move(const std::array<End, 2>& ends) {
  for (const End& end : ends) {
    const PointId to = geometry_.add_point(end.to);
    separated_.push_back({to, end.from});
    for (const auto& [t, k] : end.star) surface_.corners[t][k] = to;
  }
  for (const End& end : ends)
    for (const auto& [t, k] : end.star) {
      const auto& c = surface_.corners[t];
      surface_.plane[t] = geometry_.add_plane(PlaneDefinition::through(c[0], c[1], c[2]));
    }
}

// Of a wedge that has none for itself: nothing.
std::vector<std::vector<PlaneId>> LineSeparation::sectors_of(const Book& book,
                                                             const std::vector<bool>& have_others) {
  std::vector<std::vector<PlaneId>> sectors(book.wedges.size());
  const std::vector<WedgeGroup> groups = groups_of_wedges(kernel_, book.places.axis(), book.wedges);
  if (groups.empty()) return sectors;
  std::vector<EdgeSectors::Wedge> wholes;
  for (const WedgeGroup& group : groups) wholes.push_back(group.all);
  const EdgeSectors around(book.places.at(0), book.places.at(book.places.count() - 1), wholes,
                           geometry_, kernel_);
  for (std::size_t i = 0; i < around.order().size(); ++i) {
    const std::vector<std::uint32_t>& wedges = groups[around.order()[i]].wedges;
    if (wedges.size() == 1 && !have_others[wedges[0]])
      sectors[wedges[0]] = around.of_wedge(i).planes;
  }
  return sectors;
}

// What has a corner on the line, but no edge: it may be in anyone's sector.
std::vector<bool> LineSeparation::have_others_on_edges(const Book& book,
                                                       std::span<const PointId> on_line) const {
  std::vector<std::uint32_t> others(book.places.count() + 1, 0);  // corners before a place
  for (const PointId p : on_line) {
    const auto at = std::ranges::lower_bound(points_, p) - points_.begin();
    others[book.places.of(p) + 1] += corners_[static_cast<std::size_t>(at)];
  }
  for (const std::array<End, 2>& ends : book.ends)
    for (const End& end : ends)
      others[book.places.of(end.from) + 1] -= static_cast<std::uint32_t>(end.star.size());
  std::partial_sum(others.begin(), others.end(), others.begin());
  std::vector<bool> have_others;
  for (const auto& [low, high] : book.ends)
    have_others.push_back(others[book.places.of(low.from)] !=
                          others[book.places.of(high.from) + 1]);
  return have_others;
}

bool LineSeparation::find_places(std::array<End, 2>& ends, const EdgeSectors::Wedge& wedge,
                                 std::span<const PlaneId> sector, double clearance) {
  for (End& end : ends) {
    if (end.star.empty()) return false;
    Room room = sector.empty() ? room_in_material(end) : room_in_sector(end, wedge, sector);
    room.clearance = clearance;
    if (!has_star_in(end, room) || !find_place(end, room)) return false;
  }
  return !(ends[0].to == ends[1].to);
}

LineSeparation::Room LineSeparation::room_in_sector(const End& end, const EdgeSectors::Wedge& wedge,
                                                    std::span<const PlaneId> sector) const {
  const auto [t, k] = end.star[0];
  const Vec3& at = geometry_.position(end.from);
  const Vec3 along = of_unit_length(geometry_.position(surface_.corners[t][next_corner(k)]) - at);
  const auto across = [&](PointId p) {
    const Vec3 way = geometry_.position(p) - at;
    return of_unit_length(way - dot(way, along) * along);
  };
  return {
      {sector.begin(), sector.end()}, across(wedge.left.beside) + across(wedge.right.beside), 0};
}

// Below all faces around the end.
LineSeparation::Room LineSeparation::room_in_material(const End& end) const {
  Room room{{}, {0, 0, 0}, 0};
  const Vec3& at = geometry_.position(end.from);
  for (const auto& [t, k] : end.star) {
    room.planes.push_back(surface_.plane[t]);
    const Vec3& beside = geometry_.position(surface_.corners[t][next_corner(k)]);
    room.amid = room.amid + of_unit_length(beside - at);
  }
  std::ranges::sort(room.planes);
  room.planes.erase(std::unique(room.planes.begin(), room.planes.end()), room.planes.end());
  return room;
}

bool LineSeparation::has_star_in(const End& end, const Room& room) const {
  if (room.planes.size() > most_faces) return false;
  return std::ranges::all_of(end.star, [&](const Corner& corner) {
    const PointId beside = surface_.corners[corner.triangle][next_corner(corner.k)];
    return std::ranges::all_of(
        room.planes, [&](PlaneId plane) { return kernel_.side(beside, plane) != Sign::positive; });
  });
}

// Beside the origin, steps are as small as numbers can be.
double LineSeparation::step_around(const End& end) const {
  double step = 0;
  for (const auto& [t, k] : end.star)
    for (const PointId p : surface_.corners[t])
      step = std::max(step, grid_.step(geometry_.position(p)));
  return step;
}

bool LineSeparation::find_place(End& end, const Room& room) {
  const Vec3& exact = geometry_.position(end.from);
  ThinCone cone;
  cone.tip = grid_.nearest(exact);
  cone.to_point = exact - cone.tip;
  cone.amid = of_unit_length(room.amid);
  for (const PlaneId plane : room.planes) {
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
      const bool is_inside = std::ranges::all_of(
          room.planes, [&](PlaneId plane) { return kernel_.side(tried, plane) == Sign::negative; });
      if (is_inside && is_clear(cone, place, room.clearance * step)) return true;
    }
  return false;
}

}  // namespace sectile
