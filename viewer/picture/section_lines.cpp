#include "picture/section_lines.h"

#include <array>

namespace sectile::viewer {
namespace {

/// Where the plane cuts an edge between ends on different sides of it.
glm::dvec3 cut(const glm::dvec3& a, const glm::dvec3& b, double above_a, double above_b) {
  return a + (above_a / (above_a - above_b)) * (b - a);
}

}  // namespace

std::vector<glm::vec3> section_lines(const SurfaceMesh& mesh, const glm::dmat4& model,
                                     const glm::dvec4& plane, double aside) {
  std::vector<glm::vec3> ends;
  const glm::dvec4 own = glm::transpose(model) * plane;
  const glm::dvec3 moved = -aside * glm::normalize(glm::dvec3(plane));
  const auto in_world = [&](const glm::dvec3& p) {
    return glm::vec3(glm::dvec3(model * glm::dvec4(p, 1)) + moved);
  };
  for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
    std::array<double, 3> above;
    for (std::size_t k = 0; k < 3; ++k)
      above[k] = glm::dot(own, glm::dvec4(mesh.positions[i + k], 1));
    // A corner in the plane counts as kept, so that each triangle has two cut edges or none.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((above[k] > 0) == (above[next] > 0)) continue;
      ends.push_back(in_world(cut(glm::dvec3(mesh.positions[i + k]),
                                  glm::dvec3(mesh.positions[i + next]), above[k], above[next])));
    }
  }
  return ends;
}

}  // namespace sectile::viewer
