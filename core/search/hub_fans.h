// Polygons around hubs (search/hubs.h): fans of very many that have a corner in common, told apart
// by the directions in which they leave it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/box_tree.h"
#include "search/hubs.h"

namespace sectile {

class HubFans {
 public:
  HubFans() = default;
  /// Of some of the polygons 0 … count - 1, whose corners are points 0 … points - 1:
  /// for_each_corner(polygon, visit) calls visit(PointId). Each polygon belongs to one hub at most.
  template <class ForEachCorner>
  HubFans(std::span<const std::uint32_t> some, std::size_t count, std::size_t points,
          const ForEachCorner& for_each_corner);

  std::size_t count() const { return fans_.size(); }
  /// Per polygon: its hub, or Hubs::none. Empty if there is no hub.
  const std::vector<std::uint32_t>& of_polygon() const { return of_polygon_; }
  /// Do two polygons belong to one hub? Then for_each_pair() tells whether they may meet.
  bool same(std::uint32_t f, std::uint32_t g) const {
    return !of_polygon_.empty() && of_polygon_[f] != Hubs::none && of_polygon_[f] == of_polygon_[g];
  }
  /// Calls visit(f, g) once for each two polygons that have more than the hub in common, and some
  /// others.
  template <class ForEachCorner, class Visit>
  void for_each_pair(std::size_t hub, const Geometry& geometry,
                     const ForEachCorner& for_each_corner, const Visit& visit) const;

 private:
  std::vector<PointId> points_;
  std::vector<std::vector<std::uint32_t>> fans_;  // per hub
  std::vector<std::uint32_t> of_polygon_;         // empty if there is no hub
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
    hub_at[p] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(PointId(p));
  }
  if (points_.empty()) return;
  fans_.resize(points_.size());
  of_polygon_.assign(count, Hubs::none);
  for (const std::uint32_t f : some) {
    std::uint32_t most = 0;
    for_each_corner(f, [&](PointId p) {
      if (hub_at[p.value()] == Hubs::none || corners[p.value()] <= most) return;
      most = corners[p.value()];
      of_polygon_[f] = hub_at[p.value()];
    });
    if (of_polygon_[f] != Hubs::none) fans_[of_polygon_[f]].push_back(f);
  }
}

template <class ForEachCorner, class Visit>
void HubFans::for_each_pair(std::size_t hub, const Geometry& geometry,
                            const ForEachCorner& for_each_corner, const Visit& visit) const {
  const std::vector<std::uint32_t>& fan = fans_[hub];
  std::vector<Box> directions;
  directions.reserve(fan.size());
  std::vector<Vec3> others;
  for (const std::uint32_t f : fan) {
    others.clear();
    for_each_corner(f, [&](PointId p) {
      if (p != points_[hub]) others.push_back(geometry.position(p));
    });
    directions.push_back(direction_box(geometry.position(points_[hub]), others));
  }
  const BoxTree tree(directions);
  for (const BoxTree::SelfPart& part : tree.self_parts(1))
    tree.self_overlaps(part, [&](std::uint32_t i, std::uint32_t j) { visit(fan[i], fan[j]); });
}

}  // namespace sectile
