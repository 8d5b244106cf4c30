#include "app/picking.h"

#include <algorithm>
#include <limits>

#include "app/picture_maker.h"

namespace sectile::viewer {
namespace {

/// Distance along the ray to a triangle, or infinity.
double hit_triangle(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr double nothing = std::numeric_limits<double>::infinity();
  const glm::dvec3 ab = b - a, ac = c - a;
  const glm::dvec3 across = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, across);
  if (det == 0) return nothing;
  const glm::dvec3 from = ray.origin - a;
  const double u = glm::dot(from, across) / det;
  const glm::dvec3 q = glm::cross(from, ab);
  const double v = glm::dot(ray.direction, q) / det;
  const double t = glm::dot(ac, q) / det;
  return u < 0 || v < 0 || u + v > 1 || t < 0 ? nothing : t;
}

double hit_surface(const Ray& ray, const Surface& surface) {
  const glm::dmat4 back = glm::inverse(surface.model);
  const Ray local{glm::dvec3(back * glm::dvec4(ray.origin, 1)),
                  glm::dvec3(back * glm::dvec4(ray.direction, 0))};
  double nearest = std::numeric_limits<double>::infinity();
  const std::vector<glm::vec3>& p = surface.mesh->positions;
  for (std::size_t i = 0; i + 2 < p.size(); i += 3)
    nearest = std::min(nearest, hit_triangle(local, p[i], p[i + 1], p[i + 2]));
  return nearest;
}

/// The nodes from the root down to `id`.
std::vector<NodeId> way_to(const Scene& scene, NodeId id) {
  std::vector<NodeId> way;
  for (const Node* node = scene.find(id); node; node = scene.find(node->parent))
    way.push_back(node->id);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

NodeId pick(const Session& session, const Ray& ray, Depth depth) {
  // Operands lie within or on their result: they are meant once the result is selected.
  NodeId hit = 0, hit_operand = 0;
  double nearest = std::numeric_limits<double>::infinity(), nearest_operand = nearest;
  for (const Shape& shape : visible_shapes(session)) {
    const double t = hit_surface(ray, shape.surface);
    const bool operand = shape.is_operand;
    if (t < (operand ? nearest_operand : nearest)) {
      (operand ? nearest_operand : nearest) = t;
      (operand ? hit_operand : hit) = shape.node;
    }
  }
  if (hit_operand && (depth == Depth::inner || !hit)) return hit_operand;
  const std::vector<NodeId> way = way_to(session.scene(), hit);
  if (way.empty()) return 0;
  if (depth == Depth::outer) return way.front();
  const auto here = std::find(way.begin(), way.end(), session.selected());
  return here == way.end() || std::next(here) == way.end() ? way.back() : *std::next(here);
}

}  // namespace sectile::viewer
