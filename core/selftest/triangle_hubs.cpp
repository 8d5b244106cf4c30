#include "selftest/triangle_hubs.h"

namespace sectile {

TriangleHubs::TriangleHubs(const TriangleSurface& surface, const Geometry& geometry,
                           std::span<const std::uint32_t> triangles)
    : surface_(surface), geometry_(geometry) {
  if (triangles.size() < Hubs::least_faces) return;
  std::vector<std::uint32_t> corners(geometry.positions.size(), 0);
  for (const std::uint32_t t : triangles)
    for (const PointId p : surface.corners[t]) ++corners[p.value()];
  std::vector<std::uint32_t> hub_at;
  for (std::size_t p = 0; p < corners.size(); ++p) {
    if (corners[p] < Hubs::least_faces) continue;
    if (hub_at.empty()) hub_at.assign(corners.size(), Hubs::none);
    hub_at[p] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(PointId(p));
  }
  if (points_.empty()) return;
  fans_.resize(points_.size());
  of_triangle_.assign(surface.size(), Hubs::none);
  for (const std::uint32_t t : triangles) {
    std::uint32_t most = 0;
    for (const PointId p : surface.corners[t]) {
      if (hub_at[p.value()] == Hubs::none || corners[p.value()] <= most) continue;
      most = corners[p.value()];
      of_triangle_[t] = hub_at[p.value()];
    }
    if (of_triangle_[t] != Hubs::none) fans_[of_triangle_[t]].push_back(t);
  }
}

std::vector<Box> TriangleHubs::directions(std::size_t hub) const {
  std::vector<Box> boxes;
  boxes.reserve(fans_[hub].size());
  for (const std::uint32_t t : fans_[hub]) {
    Vec3 others[2];
    std::size_t count = 0;
    for (const PointId p : surface_.corners[t])
      if (p != points_[hub]) others[count++] = geometry_.position(p);
    boxes.push_back(direction_box(geometry_.position(points_[hub]), others));
  }
  return boxes;
}

}  // namespace sectile
