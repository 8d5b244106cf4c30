// Polygons around hubs (search/hubs.h): fans of very many that have a corner in common, told apart
// by the directions in which they leave it, or its spine.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "search/box_tree.h"
#include "search/hubs.h"
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
  /// Makes one fan of those on one line along which many edges run.
  template <class ForEachCorner>
  void join_along_spines(const Kernel& kernel, const ForEachCorner& for_each_corner);

  std::size_t count() const { return fans_.size(); }
  /// Per polygon: its fan, or Hubs::none. Empty if there is no fan.
  const std::vector<std::uint32_t>& of_polygon() const { return of_polygon_; }
  std::span<const std::uint32_t> polygons(std::size_t fan) const { return fans_[fan].polygons; }
  /// The hubs of a fan.
  std::span<const PointId> points(std::size_t fan) const { return fans_[fan].points; }
  bool is_along_spine(std::size_t fan) const { return fans_[fan].line != SpineLines::none; }
  /// Do two polygons belong to one fan? Then for_each_pair() tells whether they may meet.
  bool same(std::uint32_t f, std::uint32_t g) const {
    return !of_polygon_.empty() && of_polygon_[f] != Hubs::none && of_polygon_[f] == of_polygon_[g];
  }
  /// Calls visit(f, g) once for each two polygons that have more than the hub, or the line, in
  /// common, and some others.
  template <class ForEachCorner, class Visit>
  void for_each_pair(std::size_t fan, const Geometry& geometry,
                     const ForEachCorner& for_each_corner, const Visit& visit) const;
  /// The same for all other pairs.
  template <class ForEachCorner, class Visit>
  void for_each_other_pair(std::size_t fan, const Geometry& geometry,
                           const ForEachCorner& for_each_corner, const Visit& visit) const;

 private:
  struct Fan {
    std::vector<PointId> points;
    std::vector<std::uint32_t> polygons;
    std::uint32_t line = SpineLines::none;
  };

  template <class ForEachCorner>
  std::vector<Hubs::Spine> spines(std::span<const PointId> hubs,
                                  const ForEachCorner& for_each_corner) const;
  template <class ForEachCorner>
  std::vector<Box> boxes(const Fan& fan, const Geometry& geometry,
                         const ForEachCorner& for_each_corner) const;

  std::vector<Fan> fans_;                  // ascending by their first points
  std::vector<std::uint32_t> of_polygon_;  // empty if there is no hub
  SpineLines lines_;
};

template <class ForEachCorner>
HubFans::HubFans(std::span<const std::uint32_t> some, std::size_t count, std::size_t points,
                 const ForEachCorner& for_each_corner) {
  if (some.size() < Hubs::least_faces) return;
  std::vector<std::uint32_t> corners(points, 0);
  for (const std::uint32_t f : some) for_each_corner(f, [&](PointId p) { ++corners[p.value()]; });
  std::vector<std::uint32_t> hub_at;
  for (std::size_t p = 0; p < points; ++p) {
    if (corners[p] < Hubs::least_faces) continue;
    if (hub_at.empty()) hub_at.assign(points, Hubs::none);
    hub_at[p] = static_cast<std::uint32_t>(fans_.size());
    fans_.push_back({{PointId(p)}, {}});
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

template <class ForEachCorner>
void HubFans::join_along_spines(const Kernel& kernel, const ForEachCorner& for_each_corner) {
  std::vector<PointId> hubs;
  for (const Fan& fan : fans_) hubs.push_back(fan.points[0]);
  lines_ = SpineLines(kernel, hubs, spines(hubs, for_each_corner));
  if (lines_.count() == 0) return;
  std::vector<Fan> joined;
  std::vector<std::uint32_t> of_line(lines_.count(), Hubs::none);
  for (std::uint32_t hub = 0; hub < hubs.size(); ++hub) {
    const std::uint32_t line = lines_.of_point(hub);
    auto fan = static_cast<std::uint32_t>(joined.size());
    if (line != SpineLines::none && of_line[line] != Hubs::none)
      fan = of_line[line];
    else
      joined.emplace_back().line = line;
    if (line != SpineLines::none) of_line[line] = fan;
    joined[fan].points.push_back(hubs[hub]);
    for (const std::uint32_t f : fans_[hub].polygons) {
      joined[fan].polygons.push_back(f);
      of_polygon_[f] = fan;
    }
  }
  fans_ = std::move(joined);
}

// Each edge is one of two polygons.
template <class ForEachCorner>
std::vector<Hubs::Spine> HubFans::spines(std::span<const PointId> hubs,
                                         const ForEachCorner& for_each_corner) const {
  if (hubs.size() < 2) return {};
  std::vector<Hubs::Spine> edges;
  std::vector<std::uint32_t> corners;
  for (const Fan& fan : fans_)
    for (const std::uint32_t f : fan.polygons) {
      corners.clear();
      for_each_corner(f, [&](PointId p) {
        const auto at = std::ranges::lower_bound(hubs, p);
        const bool is_hub = at != hubs.end() && *at == p;
        corners.push_back(is_hub ? static_cast<std::uint32_t>(at - hubs.begin()) : Hubs::none);
      });
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t g = corners[i], h = corners[i + 1 < corners.size() ? i + 1 : 0];
        if (g != Hubs::none && h != Hubs::none && g != h)
          edges.push_back(Hubs::Spine::between(g, h));
      }
    }
  return Hubs::spines_among(std::move(edges), Hubs::least_faces);
}

template <class ForEachCorner>
std::vector<Box> HubFans::boxes(const Fan& fan, const Geometry& geometry,
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
    boxes.push_back(fan.line == SpineLines::none
                        ? direction_box(geometry.position(fan.points[0]), others)
                        : lines_[fan.line].box(known, others));
  }
  return boxes;
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_pair(std::size_t fan, const Geometry& geometry,
                            const ForEachCorner& for_each_corner, const Visit& visit) const {
  const std::vector<std::uint32_t>& polygons = fans_[fan].polygons;
  const BoxTree tree(boxes(fans_[fan], geometry, for_each_corner));
  for (const BoxTree::SelfPart& part : tree.self_parts(1))
    tree.self_overlaps(part,
                       [&](std::uint32_t i, std::uint32_t j) { visit(polygons[i], polygons[j]); });
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_other_pair(std::size_t fan, const Geometry& geometry,
                                  const ForEachCorner& for_each_corner, const Visit& visit) const {
  const std::vector<std::uint32_t>& polygons = fans_[fan].polygons;
  const std::vector<Box> all = boxes(fans_[fan], geometry, for_each_corner);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      if (!all[i].overlaps(all[j])) visit(polygons[i], polygons[j]);
}

}  // namespace sectile
