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
  using Class = TraceClass;
  const Directions to(record);
  std::vector<Part> parts;
  const auto add = [&](int solid, TraceClass cls, const Mesh& mesh, const Colour& colour,
                       double far, double up) {
    Part& part = parts.emplace_back();
    part.solid = solid;
    part.cls = cls;
    part.lumped = reclassified(record.operation, solid, cls);
    part.mesh = mesh;
    part.colour = colour;
    part.direction = to(solid, far, up);
    part.kept = is_kept(record.operation, solid, part.lumped == TraceClass::in);
    part.turned = part.kept && solid == 1 && record.operation == Operation::subtract;
  };
  if (!eight_way) {
    const std::array<Mesh, 4>& m = record.four_parts();
    add(0, Class::in, m[0], t.a_in_b, 0.45, 0);
    add(0, Class::out, m[1], t.a_out_b, 1.35, 0);
    add(1, Class::in, m[2], t.b_in_a, 0.45, 0);
    add(1, Class::out, m[3], t.b_out_a, 1.35, 0);
    return parts;
  }
  const std::array<Mesh, 8>& m = record.eight_parts();
  add(0, Class::in, m[0], t.a_in_b, 0.45, 0.6);
  add(0, Class::out, m[1], t.a_out_b, 1.35, 0);
  add(0, Class::on_plus, m[2], t.a_on_b_plus, 0.45, 0);
  add(0, Class::on_minus, m[3], t.a_on_b_minus, 0.45, -0.6);
  add(1, Class::in, m[4], t.b_in_a, 0.45, 0.6);
  add(1, Class::out, m[5], t.b_out_a, 1.35, 0);
  add(1, Class::on_plus, m[6], t.b_on_a_plus, 0.45, 0);
  add(1, Class::on_minus, m[7], t.b_on_a_minus, 0.45, -0.6);
  return parts;
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
