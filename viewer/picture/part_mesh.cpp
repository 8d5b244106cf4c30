// Parts of boundaries as surfaces to draw.
#include <algorithm>
#include <array>
#include <map>

#include "picture/polygon_ears.h"
#include "picture/surface_mesh.h"

namespace sectile::viewer {
namespace {

glm::dvec3 to_glm(const Vec3& p) {
  return {p.x, p.y, p.z};
}

// Newell's normal: right for any planar loop, also where corners are in line.
glm::dvec3 loop_normal(const SurfacePart& part, const std::vector<std::uint32_t>& loop) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 origin = to_glm(part.positions[loop[0]]);
    sum += glm::cross(to_glm(part.positions[loop[i]]) - origin,
                      to_glm(part.positions[loop[(i + 1) % loop.size()]]) - origin);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : glm::dvec3(0, 0, 1);
}

// The corners seen along the normal, counter-clockwise.
std::vector<glm::dvec2> flattened(const SurfacePart& part, const SurfacePart::Face& face,
                                  const glm::dvec3& normal, Loops& loops) {
  const glm::dvec3 helper = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
  const glm::dvec3 origin = to_glm(part.positions[face.loops[0][0]]);
  std::vector<glm::dvec2> places;
  for (const auto& loop : face.loops) {
    auto& ring = loops.emplace_back();
    for (const std::uint32_t index : loop) {
      const glm::dvec3 p = to_glm(part.positions[index]) - origin;
      ring.push_back(static_cast<std::uint32_t>(places.size()));
      places.emplace_back(glm::dot(p, u), glm::dot(p, v));
    }
  }
  return places;
}

void add_face(SurfaceMesh& surface, const SurfacePart& part, std::uint32_t number) {
  const SurfacePart::Face& face = part.faces[number];
  if (face.loops.empty() || face.loops[0].empty()) return;
  const glm::dvec3 normal = loop_normal(part, face.loops[0]);
  Loops loops;
  const std::vector<glm::dvec2> places = flattened(part, face, normal, loops);
  std::vector<std::uint32_t> corners;
  for (const auto& loop : face.loops) corners.insert(corners.end(), loop.begin(), loop.end());
  for (const auto& triangle : ears(places, loops)) {
    for (const std::uint32_t i : triangle) {
      surface.positions.emplace_back(to_glm(part.positions[corners[i]]));
      surface.normals.emplace_back(normal);
    }
    surface.faces.push_back(number);
  }
}

// Ascending. Faces do not always share the vertices of a common edge, but its places.
using Edge = std::array<std::array<double, 3>, 2>;

Edge edge_between(const Vec3& from, const Vec3& to) {
  Edge edge{{{from.x, from.y, from.z}, {to.x, to.y, to.z}}};
  std::sort(edge.begin(), edge.end());
  return edge;
}

void add_hard_edges(SurfaceMesh& surface, const SurfacePart& part) {
  std::map<Edge, std::vector<FaceSource>> sources_along;
  for (const SurfacePart::Face& face : part.faces) {
    for (const auto& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge edge =
            edge_between(part.positions[loop[i]], part.positions[loop[(i + 1) % loop.size()]]);
        sources_along[edge].push_back(face.source);
      }
    }
  }
  for (const auto& [edge, sources] : sources_along) {
    if (sources.size() == 2 && sources[0] == sources[1]) continue;
    for (const auto& [x, y, z] : edge) surface.hard_edges.emplace_back(glm::dvec3(x, y, z));
  }
}

}  // namespace

std::shared_ptr<const SurfaceMesh> surface_mesh(const SurfacePart& part) {
  auto surface = std::make_shared<SurfaceMesh>();
  for (std::uint32_t number = 0; number < part.faces.size(); ++number)
    add_face(*surface, part, number);
  for (const Vec3& p : part.positions) surface->bounds.add(to_glm(p));
  add_hard_edges(*surface, part);
  return surface;
}

}  // namespace sectile::viewer
