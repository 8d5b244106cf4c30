#include "picture/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "picture/smooth_groups.h"

namespace sectile::viewer {
namespace {

// An edge of a triangle, to be matched with the others along the same two vertices.
struct Side {
  std::uint64_t vertices;  // the smaller index in the upper half
  std::uint32_t triangle;
};

glm::dvec3 to_glm(const Vec3& p) {
  return {p.x, p.y, p.z};
}

struct Triangles {
  PolygonMesh mesh;
  std::vector<FaceSource> sources;
  std::vector<glm::dvec3> normals;
  std::vector<bool> slivers;  // so thin that rounding turned the normal

  std::size_t size() const { return mesh.face_sizes.size(); }
  glm::dvec3 corner(std::size_t triangle, std::size_t i) const {
    return to_glm(mesh.positions[mesh.indices[3 * triangle + i]]);
  }
};

void compute_normals(Triangles& triangles) {
  triangles.normals.resize(triangles.size());
  triangles.slivers.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const glm::dvec3 a = triangles.corner(t, 0), b = triangles.corner(t, 1),
                     c = triangles.corner(t, 2);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    const double longest =
        std::max({glm::dot(b - a, b - a), glm::dot(c - a, c - a), glm::dot(c - b, c - b)});
    triangles.slivers[t] = length <= 1e-7 * longest;
    triangles.normals[t] = length > 0 ? n / length : glm::dvec3(0);
  }
  // A sliver looks like its face: it takes the normal of another triangle of the same source.
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!triangles.slivers[t]) continue;
    for (const std::size_t other : {t - 1, t + 1})
      if (other < triangles.size() && !triangles.slivers[other] &&
          triangles.sources[other] == triangles.sources[t])
        triangles.normals[t] = triangles.normals[other];
  }
}

enum class Bend { none, smooth, hard };

// `none`: both triangles lie in one face.
Bend bend_between(const Triangles& triangles, std::uint32_t s, std::uint32_t t) {
  const FaceSource &p = triangles.sources[s], &q = triangles.sources[t];
  const double cosine = glm::dot(triangles.normals[s], triangles.normals[t]);
  const bool sliver = triangles.slivers[s] || triangles.slivers[t];
  if (p == q && (sliver || cosine > 1 - 1e-9)) return Bend::none;
  if (sliver) return Bend::hard;
  const double least = p.solid == q.solid ? cosine_of_sharpest_smooth_edge : 1 - 1e-9;
  return cosine > least ? Bend::smooth : Bend::hard;
}

// By vertices, then by triangle. Sides go to the smaller of their vertices first, which leaves only
// a few to be sorted at each: a surface of 100,000 triangles is made anew for each step of a drag.
std::vector<Side> sides_in_order(const Triangles& triangles) {
  const auto& indices = triangles.mesh.indices;
  std::vector<std::uint32_t> ends(triangles.mesh.positions.size() + 1);
  const auto for_each_side = [&](auto&& visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t from = indices[3 * t + i], to = indices[3 * t + (i + 1) % 3];
        visit(std::min(from, to), std::max(from, to), t);
      }
  };
  for_each_side([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++ends[low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::vector<std::uint32_t> begins = ends;
  std::vector<Side> sides(3 * triangles.size());
  for_each_side([&](std::uint64_t low, std::uint32_t high, std::uint32_t t) {
    sides[ends[low]++] = {low << 32 | high, t};
  });
  for (std::size_t v = 0; v + 1 < begins.size(); ++v)
    std::sort(sides.begin() + begins[v], sides.begin() + begins[v + 1],
              [](const Side& a, const Side& b) {
                return a.vertices != b.vertices ? a.vertices < b.vertices : a.triangle < b.triangle;
              });
  return sides;
}

std::uint32_t corner_at(const Triangles& triangles, std::uint32_t triangle, std::uint32_t vertex) {
  std::uint32_t corner = 3 * triangle;
  while (triangles.mesh.indices[corner] != vertex) ++corner;
  return corner;
}

// Fills the surface's edges and joins the corners across those that are not hard.
SmoothGroups sort_edges(SurfaceMesh& surface, const Triangles& triangles) {
  SmoothGroups groups(3 * triangles.size());
  const std::vector<Side> sides = sides_in_order(triangles);
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].vertices == sides[i].vertices) ++next;
    const auto low = static_cast<std::uint32_t>(sides[i].vertices >> 32),
               high = static_cast<std::uint32_t>(sides[i].vertices);
    const Bend bend = next - i == 2
                          ? bend_between(triangles, sides[i].triangle, sides[i + 1].triangle)
                          : Bend::hard;
    if (bend != Bend::hard)
      for (const std::uint32_t v : {low, high})
        groups.join(corner_at(triangles, sides[i].triangle, v),
                    corner_at(triangles, sides[i + 1].triangle, v));
    if (bend == Bend::none) continue;
    auto& edges = bend == Bend::hard ? surface.hard_edges : surface.smooth_edges;
    for (const std::uint32_t v : {low, high})
      edges.emplace_back(to_glm(triangles.mesh.positions[v]));
  }
  return groups;
}

// Each triangle counts with its angle at the corner, however its face is divided.
void add_normals(SurfaceMesh& surface, const Triangles& triangles, SmoothGroups& groups) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (triangles.slivers[t]) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const glm::dvec3 here = triangles.corner(t, i), u = triangles.corner(t, (i + 1) % 3) - here,
                       v = triangles.corner(t, (i + 2) % 3) - here;
      const double angle = std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
      groups.add(3 * t + i, triangles.normals[t] * angle);
    }
  }
  surface.normals.reserve(3 * triangles.size());
  for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
    surface.normals.emplace_back(groups.normal_at(corner, triangles.normals[corner / 3]));
}

}  // namespace

std::shared_ptr<const SurfaceMesh> surface_mesh(const Solid& solid) {
  Triangles triangles;
  triangles.mesh = solid.to_mesh(triangles.sources);
  compute_normals(triangles);

  auto surface = std::make_shared<SurfaceMesh>();
  surface->positions.reserve(3 * triangles.size());
  surface->faces.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) surface->positions.emplace_back(triangles.corner(t, i));
    surface->faces.push_back(triangles.sources[t].face);
  }
  for (const Vec3& p : triangles.mesh.positions) surface->bounds.add(to_glm(p));
  surface->closed = true;
  SmoothGroups groups = sort_edges(*surface, triangles);
  add_normals(*surface, triangles, groups);
  return surface;
}

}  // namespace sectile::viewer
