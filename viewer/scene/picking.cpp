#include "scene/picking.h"

#include <cmath>
#include <limits>

#include "scene/transforms.h"
#include "sectile/box_search.h"

namespace sectile::viewer {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A ray in the coordinates of a mesh. Its direction is not of length one, so that distances along
/// it are those of the world.
Ray pulled_back(const Ray& ray, const glm::dmat4& model) {
  const glm::dmat4 back = glm::inverse(model);
  return {glm::dvec3(back * glm::dvec4(ray.origin, 1)),
          glm::dvec3(back * glm::dvec4(ray.direction, 0))};
}

// Möller and Trumbore.
double distance_to(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return infinite;
  const glm::dvec3 s = ray.origin - a, q = glm::cross(s, ab);
  const double u = glm::dot(s, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  const double t = glm::dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? t : infinite;
}

glm::dvec3 placed(const glm::dmat4& model, const glm::dvec3& p) {
  return glm::dvec3(model * glm::dvec4(p, 1));
}

bool is_cut_away(const SectionPlane& section, const glm::dvec3& p) {
  return section.active && glm::dot(section.plane, glm::dvec4(p, 1)) > 0;
}

/// The nearest place of a segment to a pixel, seen on the screen.
double pixels_to_segment(const glm::dvec3& from, const glm::dvec3& to, glm::dvec2 pixel,
                         double& along) {
  const glm::dvec2 a(from), d = glm::dvec2(to) - a;
  const double length = glm::dot(d, d);
  along = length > 0 ? glm::clamp(glm::dot(pixel - a, d) / length, 0.0, 1.0) : 0.0;
  return glm::distance(pixel, a + d * along);
}

double largest_stretch(const glm::dmat4& m) {
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

std::size_t edge_count(const SurfaceMesh& mesh) {
  return (mesh.hard_edges.size() + mesh.smooth_edges.size()) / 2;
}

// Of the hard edges, then of the smooth ones: two for each.
const glm::vec3& edge_end(const SurfaceMesh& mesh, std::size_t i) {
  return i < mesh.hard_edges.size() ? mesh.hard_edges[i]
                                    : mesh.smooth_edges[i - mesh.hard_edges.size()];
}

// The mesh's own normals are those of bent surfaces.
glm::dvec3 normal_of_triangle(const SurfaceMesh& mesh, std::size_t triangle) {
  const glm::vec3* corner = &mesh.positions[3 * triangle];
  const glm::dvec3 a(corner[0]),
      normal = glm::cross(glm::dvec3(corner[1]) - a, glm::dvec3(corner[2]) - a);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(mesh.normals[3 * triangle]);
}

}  // namespace

struct Picker::Trees {
  std::weak_ptr<const SurfaceMesh> mesh;
  BoxSearch triangles, edges;
};

Picker::Picker() = default;
Picker::~Picker() = default;

const Picker::Trees& Picker::trees_of(const std::shared_ptr<const SurfaceMesh>& mesh) {
  std::erase_if(trees_, [](const auto& item) { return item.second->mesh.expired(); });
  std::unique_ptr<Trees>& trees = trees_[mesh.get()];
  if (!trees) {
    std::vector<Extent> triangles(mesh->positions.size() / 3), edges(edge_count(*mesh));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const glm::vec3 *p = &mesh->positions[3 * i], *q = p + 1, *r = p + 2;
      triangles[i] = {from_glm(glm::min(*p, glm::min(*q, *r))),
                      from_glm(glm::max(*p, glm::max(*q, *r)))};
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
      edges[i] = extent_around(edge_end(*mesh, 2 * i), edge_end(*mesh, 2 * i + 1));
    trees = std::make_unique<Trees>(Trees{mesh, BoxSearch(triangles), BoxSearch(edges)});
  }
  return *trees;
}

std::optional<Hit> Picker::pick(const Ray& ray, const std::vector<PickTarget>& targets,
                                const SectionPlane& section) {
  std::optional<Hit> found;
  double nearest = infinite;
  for (const PickTarget& target : targets) {
    if (!target.mesh) continue;
    const Ray local = pulled_back(ray, target.model);
    const auto& positions = target.mesh->positions;
    trees_of(target.mesh)
        .triangles.along(
            from_glm(local.origin), from_glm(local.direction), 0, nearest, [&](std::uint32_t i) {
              const double t =
                  distance_to(local, positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
              if (t >= nearest || is_cut_away(section, ray.origin + t * ray.direction)) return;
              nearest = t;
              found = Hit{target.node, {}, {}, t, i, target.mesh->faces[i]};
              found->normal =
                  glm::normalize(glm::transpose(glm::inverse(glm::dmat3(target.model))) *
                                 normal_of_triangle(*target.mesh, i));
            });
  }
  if (found) found->point = ray.origin + found->distance * ray.direction;
  return found;
}

std::optional<PickedFeature> Picker::pick_feature(const Camera& camera, glm::dvec2 pixel,
                                                  glm::dvec2 size, double reach,
                                                  const std::vector<PickTarget>& targets) {
  const Ray ray = camera.ray(pixel, size);
  const std::optional<Hit> hit = pick(ray, targets);
  // Edges on the silhouette lie beside the surface: a little behind it is still seen.
  const double pixel_there =
      camera.pixel_length(hit ? hit->point : glm::dvec3(camera.target), size);
  const double farthest = hit ? hit->distance + 2 * reach * pixel_there : infinite;

  std::optional<PickedFeature> vertex, edge;
  double vertex_pixels = reach, edge_pixels = reach;
  const auto consider = [&](const PickTarget& target, const glm::dvec3(&ends)[2]) {
    const glm::dvec3 seen[2]{camera.project(ends[0], size), camera.project(ends[1], size)};
    if (seen[0].z <= 0 || seen[1].z <= 0) return;
    double along = 0;
    const double pixels = pixels_to_segment(seen[0], seen[1], pixel, along);
    const auto is_hidden = [&](const glm::dvec3& p) {
      return glm::dot(p - ray.origin, ray.direction) > farthest;
    };
    const glm::dvec3 place = ends[0] + (ends[1] - ends[0]) * along;
    if (pixels < edge_pixels && !is_hidden(place)) {
      edge_pixels = pixels;
      edge = {PickedFeature::Kind::edge, target.node, place, {ends[0], ends[1]}, {}};
    }
    for (const int i : {0, 1}) {
      const double away = glm::distance(glm::dvec2(seen[i]), pixel);
      if (away >= vertex_pixels || is_hidden(ends[i])) continue;
      vertex_pixels = away;
      vertex = {PickedFeature::Kind::vertex, target.node, ends[i], {ends[0], ends[1]}, {}};
    }
  };
  for (const PickTarget& target : targets) {
    if (!target.mesh) continue;
    const Ray local = pulled_back(ray, target.model);
    const glm::dvec3 far_corner = target.mesh->bounds.is_empty()
                                      ? glm::dvec3(0)
                                      : placed(target.model, target.mesh->bounds.centre());
    const double stretch = largest_stretch(target.model);
    const glm::dvec3 farther = far_corner + ray.direction * target.mesh->bounds.radius() * stretch;
    const double world_margin = reach * std::max(pixel_there, camera.pixel_length(farther, size));
    const double margin = world_margin * largest_stretch(glm::inverse(target.model));
    trees_of(target.mesh)
        .edges.along(from_glm(local.origin), from_glm(local.direction), margin, farthest,
                     [&](std::uint32_t i) {
                       const SurfaceMesh& mesh = *target.mesh;
                       consider(target, {placed(target.model, edge_end(mesh, 2 * i)),
                                         placed(target.model, edge_end(mesh, 2 * i + 1))});
                     });
  }
  if (vertex) return vertex;
  if (edge) return edge;
  if (!hit) return std::nullopt;
  return PickedFeature{PickedFeature::Kind::face, hit->node, hit->point, {}, hit->normal};
}

}  // namespace sectile::viewer
