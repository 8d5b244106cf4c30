#include "arrangement/crowded_points.h"

#include "arrangement/edge_uses.h"

namespace sectile::arrangement {
namespace {

// Per corner: the plane of another face that has the edge, too, or none.
std::vector<PlaneId> planes_beyond(const Facets& facets) {
  const std::vector<EdgeUse> uses =
      edge_uses(facets, std::vector<std::uint8_t>(facets.face_count(), 1));
  std::vector<PlaneId> beyond(facets.polygons.corners.size());
  const auto plane = [&](const EdgeUse& use) { return facets.plane[facets.face_of[use.corner]]; };
  for (std::size_t i = 1; i < uses.size(); ++i) {
    const EdgeUse &use = uses[i], &before = uses[i - 1];
    if (!use.has_same_ends(before)) continue;
    beyond[use.corner] = plane(before);
    beyond[before.corner] = plane(use);
  }
  return beyond;
}

}  // namespace

CrossingFans crossing_fans(const Facets& facets, const Kernel& kernel) {
  const std::vector<PlaneId> beyond =
      facets.second_plane.empty() ? planes_beyond(facets) : facets.second_plane;
  SidedPolygons polygons;
  for (std::uint32_t f = 0; f < facets.face_count(); ++f) {
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c)
      polygons.add_side(facets.from(c), facets.to(c), beyond[c]);
    polygons.end_polygon(facets.plane[f], SidedPolygons::no_label);
  }
  return {kernel, polygons};
}

std::vector<CrowdedPoint> crowded_points(const CrossingFans& fans) {
  std::vector<CrowdedPoint> points;
  for (std::size_t fan = 0; fan < fans.count(); ++fan) {
    const auto faces = fans.at_point(fan);
    points.push_back({fans.how(fan), {faces.begin(), faces.end()}});
  }
  return points;
}

}  // namespace sectile::arrangement
