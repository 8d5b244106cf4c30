#include "scene/chamfer.h"

#include <cmath>
#include <stdexcept>

#include "scene/primitive_kind.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

/// What is computed and lies within rounding of an axis is meant to be on it.
glm::dvec3 tidy(const glm::dvec3& direction) {
  glm::dvec3 made = glm::normalize(direction);
  for (int i = 0; i < 3; ++i)
    if (std::abs(made[i]) > 1 - 1e-12) {
      const double sign = made[i] > 0 ? 1 : -1;
      made = glm::dvec3(0);
      made[i] = sign;
    }
  return made;
}

bool is_axis(const glm::dvec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z) == 1;
}

bool runs_along(const SnapTargets& solid, const SnapFeatures::Face& face,
                const SnapFeatures::Edge& edge) {
  const std::vector<Vec3> ends = solid.outline(face);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    if (ends[i] == edge.from && ends[i + 1] == edge.to) return true;
  return false;
}

/// In a face, at right angles to its edge, away from the other face's outside.
glm::dvec3 inwards(const glm::dvec3& own, const glm::dvec3& other) {
  return tidy(own * glm::dot(own, other) - other);
}

}  // namespace

ChamferEdge chamfer_edge(const SnapTargets& solid, std::size_t index) {
  const SnapFeatures::Edge& edge = solid.features().edges.at(index);
  std::vector<const SnapFeatures::Face*> beside;
  for (const SnapFeatures::Face& face : solid.features().faces)
    if (runs_along(solid, face, edge)) beside.push_back(&face);
  if (beside.size() != 2)
    throw std::invalid_argument("Only edges between two faces can be chamfered.");
  const glm::dvec3 first = tidy(to_glm(beside[0]->normal)),
                   second = tidy(to_glm(beside[1]->normal));
  // A face with corners that go inwards may lie on both sides of the other one's plane.
  const auto reaches_over = [&](const SnapFeatures::Face& face, const glm::dvec3& normal) {
    const glm::dvec3 middle = 0.5 * (to_glm(face.low) + to_glm(face.high));
    return glm::dot(middle - to_glm(edge.from), normal) >= 0;
  };
  if (reaches_over(*beside[0], second) && reaches_over(*beside[1], first))
    throw std::invalid_argument("This edge goes inwards: there is nothing to cut off.");
  return {edge.from, edge.to, from_glm(first), from_glm(second)};
}

ChamferCut chamfer_cut(const ChamferEdge& edge, double size) {
  if (!(size > 0) || !std::isfinite(size))
    throw std::invalid_argument("The size of a chamfer must be a positive number.");
  const glm::dvec3 from = to_glm(edge.from), to = to_glm(edge.to);
  const glm::dvec3 u = inwards(to_glm(edge.first), to_glm(edge.second)),
                   v = inwards(to_glm(edge.second), to_glm(edge.first));
  const glm::dvec3 along = tidy(glm::cross(u, v)), across = glm::cross(along, u);
  const glm::dvec3 middle = 0.5 * (from + to);
  const double length = glm::distance(from, to);

  ChamferCut cut;
  cut.prism.kind = &primitive_kind("extrusion");
  cut.prism.height = length;
  const double x = glm::dot(u, v), y = glm::dot(across, v);
  const bool right_angle = std::abs(x) < 1e-12;
  cut.prism.profile.outer = {
      {0, 0}, {size, 0}, right_angle ? Vec2{0, size} : Vec2{size * x, size * y}};
  Transform place;
  place.m = {u.x,     across.x, along.x, middle.x, u.y,     across.y,
             along.y, middle.y, u.z,     across.z, along.z, middle.z};
  cut.placement = Placement::of(place);
  const glm::dvec3 half = 0.5 * length * along;
  const bool reaches = (middle - half == from && middle + half == to) ||
                       (middle - half == to && middle + half == from);
  cut.is_exact = right_angle && is_axis(u) && is_axis(v) && reaches;
  return cut;
}

}  // namespace sectile::viewer
