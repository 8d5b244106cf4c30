// The features of a solid: its triangles, joined where they are of one plane.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <numeric>

#include "scene/snapping.h"
#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

struct Side {
  std::uint32_t low, high;  // vertices
  std::uint32_t triangle;
};

std::vector<Side> sides_of(const PolygonMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(mesh.indices.size());
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t from = mesh.indices[i], to = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    sides.push_back({std::min(from, to), std::max(from, to), i / 3});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  return sides;
}

glm::dvec3 normal_of(const PolygonMesh& mesh, std::size_t triangle) {
  const auto corner = [&](std::size_t i) {
    return to_glm(mesh.positions[mesh.indices[3 * triangle + i]]);
  };
  const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  const double length = glm::length(n);
  return length > 0 ? n / length : n;
}

struct Regions {
  std::vector<std::uint32_t> parent;
  explicit Regions(std::size_t count) : parent(count) {
    std::iota(parent.begin(), parent.end(), 0u);
  }
  std::uint32_t find(std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  }
};

void grow(SnapFeatures::Face& face, const Vec3& p) {
  face.low = {std::min(face.low.x, p.x), std::min(face.low.y, p.y), std::min(face.low.z, p.z)};
  face.high = {std::max(face.high.x, p.x), std::max(face.high.y, p.y), std::max(face.high.z, p.z)};
}

void add_faces(const PolygonMesh& mesh, const std::vector<glm::dvec3>& normals, Regions& regions,
               SnapFeatures& made) {
  std::map<std::uint32_t, std::size_t> faces;
  for (std::uint32_t t = 0; t < normals.size(); ++t) {
    const std::uint32_t region = regions.find(t);
    const auto [place, is_new] = faces.try_emplace(region, made.faces.size());
    const std::uint32_t* corner = &mesh.indices[3 * t];
    const Vec3& first = mesh.positions[corner[0]];
    if (is_new)
      made.faces.push_back(
          {first, from_glm(normals[region]), first, first, {corner[0], corner[1], corner[2]}, 0});
    for (std::uint32_t i = 0; i < 3; ++i)
      grow(made.faces[place->second], mesh.positions[mesh.indices[3 * t + i]]);
  }
}

void renumber(SnapFeatures::Vertex& vertex, SnapFeatures::CornerIndex first) {
  vertex.corner += first;
}
template <class EdgeOrFace>
void renumber(EdgeOrFace& feature, SnapFeatures::CornerIndex first) {
  for (SnapFeatures::CornerIndex& corner : feature.corners) corner += first;
}

}  // namespace

void SnapFeatures::add(const SnapFeatures& more, std::uint32_t part) {
  const auto first = static_cast<CornerIndex>(corners.size());
  corners.insert(corners.end(), more.corners.begin(), more.corners.end());
  const auto append = [&](auto& all, const auto& added) {
    for (auto feature : added) {
      feature.part = part;
      renumber(feature, first);
      all.push_back(feature);
    }
  };
  append(vertices, more.vertices);
  append(edges, more.edges);
  append(faces, more.faces);
}

SnapTargets::SnapTargets(SnapFeatures all, ExactTransform place)
    : features_(std::move(all)), place_(std::move(place)) {
  std::vector<Extent> vertices, edges, faces;
  for (const auto& v : features_.vertices) vertices.push_back({v.point, v.point});
  for (const auto& e : features_.edges)
    edges.push_back(extent_around(to_glm(e.from), to_glm(e.to)));
  for (const auto& f : features_.faces) faces.push_back({f.low, f.high});
  vertices_ = BoxSearch(vertices);
  edges_ = BoxSearch(edges);
  faces_ = BoxSearch(faces);
}

std::vector<Vec3> SnapTargets::outline(const SnapFeatures::Face& face) const {
  const glm::dvec3 n = to_glm(face.normal), low = to_glm(face.low), high = to_glm(face.high);
  const double thin = 1e-6 * glm::length(high - low);
  const auto is_on = [&](const Vec3& p) {
    return std::abs(glm::dot(to_glm(p) - to_glm(face.point), n)) <= thin;
  };
  std::vector<Vec3> ends;
  edges_.near(extent_around(low, high, thin), [&](std::uint32_t i) {
    const SnapFeatures::Edge& edge = features_.edges[i];
    if (is_on(edge.from) && is_on(edge.to)) ends.insert(ends.end(), {edge.from, edge.to});
  });
  return ends;
}

SnapFeatures snap_features(const Solid& inside, const Transform& world) {
  ExactMesh exact = exact_mesh(inside);
  PolygonMesh& mesh = exact.mesh;
  if (!is_identity(world)) mesh = transformed(mesh, world);
  std::vector<glm::dvec3> normals(mesh.face_sizes.size());
  for (std::size_t t = 0; t < normals.size(); ++t) normals[t] = normal_of(mesh, t);

  SnapFeatures made;
  made.corners = std::move(exact.corners);
  Regions regions(normals.size());
  std::vector<bool> is_end(mesh.positions.size());
  const std::vector<Side> sides = sides_of(mesh);
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].low == sides[i].low &&
           sides[next].high == sides[i].high)
      ++next;
    const std::uint32_t s = sides[i].triangle, t = sides[next - 1].triangle;
    if (next - i == 2 && glm::dot(normals[s], normals[t]) > 1 - 1e-12) {
      regions.parent[regions.find(s)] = regions.find(t);
      continue;
    }
    is_end[sides[i].low] = is_end[sides[i].high] = true;
    made.edges.push_back({mesh.positions[sides[i].low],
                          mesh.positions[sides[i].high],
                          {sides[i].low, sides[i].high},
                          0});
  }
  for (SnapFeatures::CornerIndex v = 0; v < is_end.size(); ++v)
    if (is_end[v]) made.vertices.push_back({mesh.positions[v], v, 0});
  add_faces(mesh, normals, regions, made);
  return made;
}

}  // namespace sectile::viewer
