#include "story/exploded_parts.h"

#include <cmath>
#include <utility>

namespace sectile::viewer {
namespace {

// A's parts move away from B, B's from A; those inside less far than those outside. The parts on
// the other boundary, of eight, move beside those inside.
struct Directions {
  glm::dvec3 along, aside;

  explicit Directions(const StoryRecord& record) {
    const Bounds &a = record.operand(0)->bounds, &b = record.operand(1)->bounds;
    const double size = record.bounds.radius();
    along = a.is_empty() || b.is_empty() ? glm::dvec3(0) : b.centre() - a.centre();
    along = glm::length(along) < 0.05 * size ? glm::dvec3(1, 0, 0) : glm::normalize(along);
    const glm::dvec3 up = std::abs(along.z) < 0.8 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    aside = glm::normalize(up - along * glm::dot(up, along));
    along *= size;
    aside *= size;
  }
  glm::dvec3 operator()(int solid, double far, double up) const {
    return along * (solid == 0 ? -far : far) + aside * up;
  }
};

bool is_kept(Operation operation, int solid, bool inside) {
  const bool wants_inside =
      operation == Operation::intersect || (operation == Operation::subtract && solid == 1);
  return inside == wants_inside;
}

}  // namespace

std::vector<Part> parts_of(const StoryRecord& record, const Theme& t, bool eight_way) {
  const Directions to(record);
  const Operation operation = record.operation;
  const bool turned = operation == Operation::subtract;
  if (!eight_way) {
    const auto& [a_in_b, a_out_b, b_in_a, b_out_a] = record.four_parts();
    return {{"AinB", a_in_b, t.a_in_b, to(0, 0.45, 0), is_kept(operation, 0, true), false},
            {"AoutB", a_out_b, t.a_out_b, to(0, 1.35, 0), is_kept(operation, 0, false), false},
            {"BinA", b_in_a, t.b_in_a, to(1, 0.45, 0), is_kept(operation, 1, true), turned},
            {"BoutA", b_out_a, t.b_out_a, to(1, 1.35, 0), is_kept(operation, 1, false), false}};
  }
  // Equation (5) takes the parts that lie on the other boundary from A alone.
  const auto& m = record.eight_parts();
  return {{"AinB", m[0], t.a_in_b, to(0, 0.45, 0.6), is_kept(operation, 0, true), false},
          {"AoutB", m[1], t.a_out_b, to(0, 1.35, 0), is_kept(operation, 0, false), false},
          {"AonB+", m[2], t.a_on_b_plus, to(0, 0.45, 0), !turned, false},
          {"AonB-", m[3], t.a_on_b_minus, to(0, 0.45, -0.6), turned, false},
          {"BinA", m[4], t.b_in_a, to(1, 0.45, 0.6), is_kept(operation, 1, true), turned},
          {"BoutA", m[5], t.b_out_a, to(1, 1.35, 0), is_kept(operation, 1, false), false},
          {"BonA+", m[6], t.b_on_a_plus, to(1, 0.45, 0), false, false},
          {"BonA-", m[7], t.b_on_a_minus, to(1, 0.45, -0.6), false, false}};
}

Mesh turned_inside_out(const SurfaceMesh& mesh) {
  auto turned = std::make_shared<SurfaceMesh>(mesh);
  for (std::size_t i = 0; i + 2 < turned->positions.size(); i += 3) {
    std::swap(turned->positions[i + 1], turned->positions[i + 2]);
    std::swap(turned->normals[i + 1], turned->normals[i + 2]);
  }
  for (glm::vec3& normal : turned->normals) normal = -normal;
  return turned;
}

}  // namespace sectile::viewer
