#include "story/split_plane.h"

#include <cmath>

#include "picture/theme.h"

namespace sectile::viewer {

Surface plane_of_split(const StoryRecord& record, const Colour& colour) {
  const HalfSpace& plane = record.split->plane;
  const glm::dvec3 normal(plane.a, plane.b, plane.c);
  const double length = glm::length(normal);
  const glm::dvec3 n = normal / length, centre = record.bounds.centre();
  const glm::dvec3 foot = centre - n * ((glm::dot(normal, centre) + plane.d) / length);
  const glm::dvec3 helper = std::abs(n.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, n)), v = glm::cross(n, u);
  const glm::dvec3 half = (record.bounds.high - record.bounds.low) * 0.5;
  const double along_u = 1.15 * glm::dot(half, glm::abs(u)),
               along_v = 1.15 * glm::dot(half, glm::abs(v));
  auto mesh = std::make_shared<SurfaceMesh>();
  const auto corner = [&](int i) {
    const double s = i == 0 || i == 3 ? -1 : 1, t = i < 2 ? -1 : 1;
    return foot + u * (s * along_u) + v * (t * along_v);
  };
  for (const int i : {0, 1, 2, 0, 2, 3}) {
    mesh->positions.emplace_back(corner(i));
    mesh->normals.emplace_back(n);
    mesh->bounds.add(corner(i));
  }
  mesh->faces = {0, 0};
  for (int i = 0; i < 4; ++i) {
    mesh->hard_edges.emplace_back(corner(i));
    mesh->hard_edges.emplace_back(corner((i + 1) % 4));
  }
  Surface surface;
  surface.mesh = std::move(mesh);
  surface.colour = with_alpha(colour, 0.25f);
  surface.translucent = true;
  return surface;
}

}  // namespace sectile::viewer
