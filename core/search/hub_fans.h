// Polygons around hubs (search/hubs.h): fans of very many that have a corner in common, told apart
// by the directions in which they leave it, or a line along which very many edges run.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "search/arc_partition.h"
#include "search/box_tree.h"
#include "search/crossing_fans.h"
#include "search/hubs.h"
#include "search/places_on_line.h"
#include "search/spine_lines.h"

namespace sectile {

class HubFans {
 public:
  HubFans() = default;
  /// Of some of the polygons 0 … count - 1, whose corners are points 0 … points - 1:
  /// for_each_corner(polygon, visit) calls visit(PointId). Each polygon belongs to one fan at most.
  template <class ForEachCorner>
  HubFans(std::span<const std::uint32_t> some, std::size_t count, std::size_t points,
          const ForEachCorner& for_each_corner);
  /// Edges between two hubs that very many polygons have.
  template <class ForEachCorner>
  std::vector<PointPair> spines(const ForEachCorner& for_each_corner) const;
  /// Makes one fan of the polygons (the same ones) that have corners on one line along which many
  /// edges run between two hubs.
  template <class ForEachCorner>
  void join_along_spines(std::span<const std::uint32_t> some, const Kernel& kernel,
                         const ForEachCorner& for_each_corner) {
    join_along(spines(for_each_corner), some, kernel, for_each_corner);
  }
  /// Beside each other, whatever their ends are.
  template <class ForEachCorner>
  void join_along_crowded_lines(std::span<const std::uint32_t> some, const Kernel& kernel,
                                const ForEachCorner& for_each_corner);
  /// Adds fans around crossings of edges, of some polygons that are in no larger fan, and along no
  /// line: those of the crossings are numbered in this order.
  void join_around_crossings(std::span<const std::uint32_t> some, const CrossingFans& crossings);

  std::size_t count() const { return fans_.size(); }
  /// Per polygon: its fan, or Hubs::none. Empty if there is no fan.
  const std::vector<std::uint32_t>& of_polygon() const { return of_polygon_; }
  std::span<const std::uint32_t> polygons(std::size_t fan) const { return fans_[fan].polygons; }
  /// The hub of a fan, or all points on its line, ascending; none of a crossing.
  std::span<const PointId> points(std::size_t fan) const { return fans_[fan].points; }
  bool any_lines() const { return lines_.count() > 0; }
  const SpineLines& lines() const { return lines_; }
  bool is_along_line(std::size_t fan) const { return fans_[fan].line != SpineLines::none; }
  /// Do two polygons belong to one fan? Then for_each_pair() tells whether they may meet.
  bool same(std::uint32_t f, std::uint32_t g) const {
    return !of_polygon_.empty() && of_polygon_[f] != Hubs::none && of_polygon_[f] == of_polygon_[g];
  }
  /// Calls visit(f, g) once for each two polygons that have more than the hub, or the line, in
  /// common, and some others.
  template <class ForEachCorner, class Visit>
  void for_each_pair(std::size_t fan, const Geometry& geometry,
                     const ForEachCorner& for_each_corner, const Visit& visit) const;
  /// Calls visit(f, g) for each point in which a polygon g of a line has a corner within an edge of
  /// f on the line, with one such g.
  template <class ForEachCorner, class Visit>
  void for_each_corner_within_edge(std::size_t fan, const Kernel& kernel,
                                   const ForEachCorner& for_each_corner, const Visit& visit) const;
  /// for_each_pair() for all other pairs, which meet along the line at most.
  template <class ForEachCorner, class Visit>
  void for_each_other_pair(std::size_t fan, const Geometry& geometry,
                           const ForEachCorner& for_each_corner, const Visit& visit) const;

 private:
  struct Fan {
    std::vector<PointId> points;
    std::vector<std::uint32_t> polygons;
    std::uint32_t line = SpineLines::none;
    std::vector<SeenArc> arcs;  // of a crossing
  };

  template <class ForEachCorner, class Visit>
  static void for_each_edge(std::span<const std::uint32_t> polygons,
                            const ForEachCorner& for_each_corner, const Visit& visit);
  template <class ForEachCorner>
  void join_along(std::span<const PointPair> edges, std::span<const std::uint32_t> some,
                  const Kernel& kernel, const ForEachCorner& for_each_corner);
  std::vector<PointId> all_points() const;
  template <class ForEachCorner>
  std::vector<SeenArc> arcs(const Fan& fan, const Geometry& geometry,
                            const ForEachCorner& for_each_corner) const;
  template <class ForEachCorner>
  std::vector<Box> boxes_along_line(const Fan& fan, const Geometry& geometry,
                                    const ForEachCorner& for_each_corner) const;

  std::size_t count_ = 0, points_ = 0;
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> of_polygon_;  // empty if there is no fan
  SpineLines lines_;
};

template <class ForEachCorner>
HubFans::HubFans(std::span<const std::uint32_t> some, std::size_t count, std::size_t points,
                 const ForEachCorner& for_each_corner)
    : count_(count), points_(points) {
  if (some.size() < Hubs::least_faces) return;
  std::vector<std::uint32_t> corners(points, 0);
  for (const std::uint32_t f : some) for_each_corner(f, [&](PointId p) { ++corners[p.value()]; });
  std::vector<std::uint32_t> hub_at;
  for (std::size_t p = 0; p < points; ++p) {
    if (corners[p] < Hubs::least_faces) continue;
    if (hub_at.empty()) hub_at.assign(points, Hubs::none);
    hub_at[p] = static_cast<std::uint32_t>(fans_.size());
    fans_.push_back({{PointId(p)}, {}, SpineLines::none, {}});
  }
  if (fans_.empty()) return;
  of_polygon_.assign(count, Hubs::none);
  for (const std::uint32_t f : some) {
    std::uint32_t most = 0;
    for_each_corner(f, [&](PointId p) {
      if (hub_at[p.value()] == Hubs::none || corners[p.value()] <= most) return;
      most = corners[p.value()];
      of_polygon_[f] = hub_at[p.value()];
    });
    if (of_polygon_[f] != Hubs::none) fans_[of_polygon_[f]].polygons.push_back(f);
  }
}

// Each edge is one of two polygons.
template <class ForEachCorner>
std::vector<PointPair> HubFans::spines(const ForEachCorner& for_each_corner) const {
  if (fans_.size() < 2) return {};
  const auto is_hub = [&](std::uint32_t p) {
    return std::ranges::binary_search(fans_, PointId(p), {},
                                      [](const Fan& fan) { return fan.points[0]; });
  };
  std::vector<PointPair> between;
  for (const Fan& fan : fans_)
    for_each_edge(fan.polygons, for_each_corner, [&](const PointPair& e) {
      if (is_hub(e.from) && is_hub(e.to)) between.push_back(e);
    });
  return Hubs::spines_among(std::move(between), Hubs::least_faces);
}

template <class ForEachCorner>
void HubFans::join_along_crowded_lines(std::span<const std::uint32_t> some, const Kernel& kernel,
                                       const ForEachCorner& for_each_corner) {
  std::vector<PointPair> edges;
  for_each_edge(some, for_each_corner, [&](const PointPair& e) { edges.push_back(e); });
  join_along(crowded_lines(kernel, all_points(), edges, 2 * Hubs::least_faces), some, kernel,
             for_each_corner);
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_edge(std::span<const std::uint32_t> polygons,
                            const ForEachCorner& for_each_corner, const Visit& visit) {
  std::vector<PointId> corners;
  for (const std::uint32_t f : polygons) {
    corners.clear();
    for_each_corner(f, [&](PointId p) { corners.push_back(p); });
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const PointId p = corners[i], q = corners[i + 1 < corners.size() ? i + 1 : 0];
      if (p != q) visit(PointPair::between(p.value(), q.value()));
    }
  }
}

// The fans of lines are the first ones; those of hubs lose to them what has a corner there.
template <class ForEachCorner>
void HubFans::join_along(std::span<const PointPair> edges, std::span<const std::uint32_t> some,
                         const Kernel& kernel, const ForEachCorner& for_each_corner) {
  lines_ = SpineLines(kernel, all_points(), edges);
  if (!any_lines()) return;
  std::vector<Fan> fans(lines_.count());
  for (const auto& [point, line] : lines_.points()) {
    fans[line].points.push_back(PointId(point));
    fans[line].line = line;
  }
  of_polygon_.assign(count_, Hubs::none);
  for (const std::uint32_t f : some) {
    const std::uint32_t line =
        lines_.line_of_most([&](const auto& visit) { for_each_corner(f, visit); });
    if (line == SpineLines::none) continue;
    of_polygon_[f] = line;
    fans[line].polygons.push_back(f);
  }
  for (Fan& fan : fans_) {
    std::erase_if(fan.polygons, [&](std::uint32_t f) { return of_polygon_[f] != Hubs::none; });
    for (const std::uint32_t f : fan.polygons)
      of_polygon_[f] = static_cast<std::uint32_t>(fans.size());
    fans.push_back(std::move(fan));
  }
  fans_ = std::move(fans);
}

inline void HubFans::join_around_crossings(std::span<const std::uint32_t> some,
                                           const CrossingFans& crossings) {
  if (crossings.count() == 0) return;
  if (of_polygon_.empty()) of_polygon_.assign(count_, Hubs::none);
  for (std::size_t c = 0; c < crossings.count(); ++c) {
    const auto number = static_cast<std::uint32_t>(fans_.size());
    Fan& fan = fans_.emplace_back();
    const std::span<const std::uint32_t> polygons = crossings.polygons(c);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const std::uint32_t f = some[polygons[i]], before = of_polygon_[f];
      if (before != Hubs::none &&
          (is_along_line(before) || fans_[before].polygons.size() >= polygons.size()))
        continue;
      of_polygon_[f] = number;
      fan.polygons.push_back(f);
      fan.arcs.push_back(crossings.arcs(c)[i]);
    }
  }
  for (std::uint32_t fan = 0; fan + crossings.count() < fans_.size(); ++fan)
    std::erase_if(fans_[fan].polygons, [&](std::uint32_t f) { return of_polygon_[f] != fan; });
}

inline std::vector<PointId> HubFans::all_points() const {
  std::vector<PointId> all;
  all.reserve(points_);
  for (std::size_t p = 0; p < points_; ++p) all.push_back(PointId(p));
  return all;
}

template <class ForEachCorner>
std::vector<SeenArc> HubFans::arcs(const Fan& fan, const Geometry& geometry,
                                   const ForEachCorner& for_each_corner) const {
  if (!fan.arcs.empty()) return fan.arcs;
  std::vector<SeenArc> arcs;
  arcs.reserve(fan.polygons.size());
  std::vector<Vec3> others;
  for (const std::uint32_t f : fan.polygons) {
    others.clear();
    for_each_corner(f, [&](PointId p) {
      if (p != fan.points[0]) others.push_back(geometry.position(p));
    });
    arcs.push_back(SeenArc::from_point(geometry.position(fan.points[0]), others));
  }
  return arcs;
}

template <class ForEachCorner>
std::vector<Box> HubFans::boxes_along_line(const Fan& fan, const Geometry& geometry,
                                           const ForEachCorner& for_each_corner) const {
  std::vector<Box> boxes;
  boxes.reserve(fan.polygons.size());
  std::vector<Vec3> known, others;
  for (const std::uint32_t f : fan.polygons) {
    known.clear();
    others.clear();
    for_each_corner(f, [&](PointId p) {
      (std::ranges::binary_search(fan.points, p) ? known : others).push_back(geometry.position(p));
    });
    boxes.push_back(lines_[fan.line].box(known, others));
  }
  return boxes;
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_pair(std::size_t fan, const Geometry& geometry,
                            const ForEachCorner& for_each_corner, const Visit& visit) const {
  const std::vector<std::uint32_t>& polygons = fans_[fan].polygons;
  const auto visit_pair = [&](std::uint32_t i, std::uint32_t j) {
    visit(polygons[i], polygons[j]);
  };
  if (!is_along_line(fan))
    return ArcPartition(arcs(fans_[fan], geometry, for_each_corner)).for_each_pair(visit_pair);
  const BoxTree tree(boxes_along_line(fans_[fan], geometry, for_each_corner));
  for (const BoxTree::SelfPart& part : tree.self_parts(1)) tree.self_overlaps(part, visit_pair);
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_corner_within_edge(std::size_t fan, const Kernel& kernel,
                                          const ForEachCorner& for_each_corner,
                                          const Visit& visit) const {
  if (!is_along_line(fan)) return;
  const PlacesOnLine places(kernel, points(fan));
  std::vector<std::uint32_t> with_corner(places.count(), Hubs::none);
  std::vector<std::size_t> on_line;  // per corner of a polygon: its place, or what is none
  const auto find_places = [&](std::uint32_t f) {
    on_line.clear();
    for_each_corner(f, [&](PointId p) {
      on_line.push_back(std::ranges::binary_search(points(fan), p) ? places.of(p) : places.count());
    });
  };
  for (const std::uint32_t f : polygons(fan)) {
    find_places(f);
    for (const std::size_t place : on_line)
      if (place < places.count() && with_corner[place] == Hubs::none) with_corner[place] = f;
  }
  for (const std::uint32_t f : polygons(fan)) {
    find_places(f);
    for (std::size_t i = 0; i < on_line.size(); ++i) {
      const auto [low, high] = std::minmax(on_line[i], on_line[i + 1 < on_line.size() ? i + 1 : 0]);
      if (high == places.count()) continue;
      for (std::size_t place = low + 1; place < high; ++place)
        if (const std::uint32_t g = with_corner[place]; g != Hubs::none && g != f) visit(f, g);
    }
  }
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_other_pair(std::size_t fan, const Geometry& geometry,
                                  const ForEachCorner& for_each_corner, const Visit& visit) const {
  const std::vector<std::uint32_t>& polygons = fans_[fan].polygons;
  const std::vector<Box> all = boxes_along_line(fans_[fan], geometry, for_each_corner);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      if (!all[i].overlaps(all[j])) visit(polygons[i], polygons[j]);
}

}  // namespace sectile
