// Parts of boundaries as surfaces to draw.
#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "picture/smooth_groups.h"
#include "picture/surface_mesh.h"
#include "sectile/errors.h"
#include "sectile/triangulation.h"

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

// As numbers of corners, loop after loop. Corners are rounded: where holes come to cross what they
// touched, they are filled.
std::vector<CornerTriangle> triangles_of(const std::vector<Vec3>& corners,
                                         const std::vector<std::uint32_t>& loop_ends) {
  try {
    return triangulate(corners, loop_ends);
  } catch (const InvalidSolid&) {
    const std::uint32_t outer = loop_ends.front();
    return triangulate(std::span(corners).first(outer), std::span(&outer, 1));
  }
}

// The corners of all loops of all faces have numbers, one after another.
struct Corners {
  std::vector<std::uint32_t> first_of_face;
  std::vector<glm::dvec3> normals;  // of each face

  explicit Corners(const SurfacePart& part) {
    std::uint32_t count = 0;
    for (const SurfacePart::Face& face : part.faces) {
      first_of_face.push_back(count);
      for (const auto& loop : face.loops) count += static_cast<std::uint32_t>(loop.size());
      const bool none = face.loops.empty() || face.loops[0].empty();
      normals.push_back(none ? glm::dvec3(0) : loop_normal(part, face.loops[0]));
    }
    first_of_face.push_back(count);
  }
};

// Ascending. Faces do not always share the vertices of a common edge, but its places.
using Edge = std::array<std::array<double, 3>, 2>;

// A face along an edge, with its corners at the edge's first and second end.
struct Along {
  std::uint32_t face = 0, at_first = 0, at_second = 0;
};

std::map<Edge, std::vector<Along>> edges_of(const SurfacePart& part, const Corners& corners) {
  std::map<Edge, std::vector<Along>> edges;
  for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
    std::uint32_t first = corners.first_of_face[f];
    for (const auto& loop : part.faces[f].loops) {
      const auto size = static_cast<std::uint32_t>(loop.size());
      for (std::uint32_t i = 0; i < size; ++i) {
        const Vec3 &p = part.positions[loop[i]], &q = part.positions[loop[(i + 1) % size]];
        Edge edge{{{p.x, p.y, p.z}, {q.x, q.y, q.z}}};
        Along along{f, first + i, first + (i + 1) % size};
        if (edge[1] < edge[0]) {
          std::swap(edge[0], edge[1]);
          std::swap(along.at_first, along.at_second);
        }
        edges[edge].push_back(along);
      }
      first += size;
    }
  }
  return edges;
}

// Fills the surface's edges and joins the corners across those that are not hard.
SmoothGroups sort_edges(SurfaceMesh& surface, const SurfacePart& part, const Corners& corners) {
  SmoothGroups groups(corners.first_of_face.back());
  for (const auto& [edge, along] : edges_of(part, corners)) {
    const bool inner = along.size() == 2;
    const double cosine =
        inner ? glm::dot(corners.normals[along[0].face], corners.normals[along[1].face]) : 0;
    const bool smooth = cosine > cosine_of_sharpest_smooth_edge;
    // A face and its image, if a solid was united with its own moved copy, have one source, too.
    const bool one_face =
        cosine > 1 - 1e-6 && part.faces[along[0].face].source == part.faces[along[1].face].source;
    if (smooth) {
      groups.join(along[0].at_first, along[1].at_first);
      groups.join(along[0].at_second, along[1].at_second);
    }
    if (one_face) continue;
    for (const auto& [x, y, z] : edge)
      (smooth ? surface.smooth_edges : surface.hard_edges).emplace_back(glm::dvec3(x, y, z));
  }
  for (std::uint32_t f = 0; f < part.faces.size(); ++f)
    for (std::uint32_t c = corners.first_of_face[f]; c < corners.first_of_face[f + 1]; ++c)
      groups.add(c, corners.normals[f]);
  return groups;
}

void add_face(SurfaceMesh& surface, const SurfacePart& part, std::uint32_t number,
              const Corners& numbered, SmoothGroups& groups) {
  const SurfacePart::Face& face = part.faces[number];
  if (face.loops.empty() || face.loops[0].empty()) return;
  const glm::dvec3 normal = numbered.normals[number];
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> loop_ends;
  for (const auto& loop : face.loops) {
    for (const std::uint32_t position : loop) corners.push_back(part.positions[position]);
    loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  for (const CornerTriangle& triangle : triangles_of(corners, loop_ends)) {
    for (const std::uint32_t i : triangle) {
      surface.positions.emplace_back(to_glm(corners[i]));
      surface.normals.emplace_back(groups.normal_at(numbered.first_of_face[number] + i, normal));
    }
    surface.faces.push_back(number);
  }
}

}  // namespace

std::shared_ptr<const SurfaceMesh> surface_mesh(const SurfacePart& part) {
  auto surface = std::make_shared<SurfaceMesh>();
  const Corners corners(part);
  SmoothGroups groups = sort_edges(*surface, part, corners);
  for (std::uint32_t number = 0; number < part.faces.size(); ++number)
    add_face(*surface, part, number, corners, groups);
  for (const Vec3& p : part.positions) surface->bounds.add(to_glm(p));
  return surface;
}

}  // namespace sectile::viewer
