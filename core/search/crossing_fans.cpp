#include "search/crossing_fans.h"

#include <algorithm>

#include "search/approximate.h"
#include "search/box_tree.h"
#include "search/edge_crossings.h"
#include "search/edges_by_line.h"
#include "search/hubs.h"

namespace sectile {
namespace {

using namespace approximate;

Bounds bounds_of(const Geometry& geometry, std::span<const SidedPolygons::Side> sides) {
  Bounds bounds;
  for (const SidedPolygons::Side& side : sides) bounds.add(geometry.position(side.from));
  return bounds;
}

// In this box is what a polygon is long beside its distance from.
Box reach(Bounds bounds) {
  const double about = max_norm(bounds.high - bounds.low) / 2;
  bounds.add(bounds.low - Vec3{about, about, about});
  bounds.add(bounds.high + Vec3{about, about, about});
  return bounds.box();
}

struct Seen {
  SeenArc arc;  // not known if the point is within the polygon
  bool has_point;
};

Seen seen_from(const Kernel& kernel, PointId point, const SidedPolygons& polygons,
               std::size_t polygon) {
  const Geometry& geometry = kernel.geometry();
  const Vec3& place = geometry.position(point);
  PointId from, to;  // of the edge that has the point within it
  for (const SidedPolygons::Side& side : polygons.sides(polygon))
    if (is_within_edge(kernel, point, side.from, side.to)) from = side.from, to = side.to;
  std::vector<Vec3> others;
  bool is_corner = false;
  for (const auto& [corner, next, beyond] : polygons.sides(polygon)) {
    if (corner == from || corner == to) continue;
    if (geometry.position(corner) == place && kernel.same_point(corner, point))
      is_corner = true;
    else
      others.push_back(geometry.position(corner));
  }
  if (from.valid()) return {SeenArc::from_edge(place, geometry.position(to), others), true};
  return {SeenArc::from_point(place, others), is_corner};
}

}  // namespace

CrossingFans::CrossingFans(const Kernel& kernel, const SidedPolygons& polygons) {
  const std::vector<Construction> crossings = crowded_crossings(kernel, polygons);
  if (crossings.empty()) return;
  geometry_ = kernel.geometry();
  for (const Construction& how : crossings) {
    const auto [position, is_explicit] = kernel.construct(how);
    const PointId point =
        is_explicit ? geometry_.add_point(position) : geometry_.add_point(how, position);
    fans_.push_back({how, point, {}, {}, {}});
  }
  add_polygons(polygons);
  leave_out_small_ones();
}

void CrossingFans::add_polygons(const SidedPolygons& polygons) {
  constexpr std::size_t most_asked = 4;
  const Kernel kernel(geometry_, {});
  std::vector<Box> boxes;
  for (const Fan& fan : fans_) {
    const Vec3& place = geometry_.position(fan.point);
    boxes.push_back(box_around(place, place));
  }
  const BoxTree tree(boxes);
  of_polygon_.assign(polygons.count(), none);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < polygons.count(); ++i) {
    const Bounds bounds = bounds_of(geometry_, polygons.sides(i));
    const Box about = reach(bounds);
    near.clear();
    tree.query([&](const Box& box) { return box.overlaps(about); },
               [&](std::uint32_t fan) { near.push_back(fan); });
    std::ranges::sort(near);
    std::size_t asked = 0;
    for (const std::uint32_t number : near) {
      Fan& fan = fans_[number];
      const bool may_have = bounds.contains(geometry_.position(fan.point)),
                 is_wanted = of_polygon_[i] == none && ++asked <= most_asked;
      if (!may_have && !is_wanted) continue;
      const Seen seen = seen_from(kernel, fan.point, polygons, i);
      if (seen.has_point) fan.at_point.push_back(i);
      if (!is_wanted || !seen.arc.is_known()) continue;
      of_polygon_[i] = number;
      fan.polygons.push_back(i);
      fan.arcs.push_back(seen.arc);
    }
  }
}

void CrossingFans::leave_out_small_ones() {
  std::vector<Fan> large;
  for (Fan& fan : fans_) {
    const bool is_large = fan.at_point.size() >= Hubs::least_faces;
    const auto number = is_large ? static_cast<std::uint32_t>(large.size()) : none;
    for (const std::uint32_t i : fan.polygons) of_polygon_[i] = number;
    if (is_large) large.push_back(std::move(fan));
  }
  fans_ = std::move(large);
  if (fans_.empty()) of_polygon_.clear();
}

}  // namespace sectile
