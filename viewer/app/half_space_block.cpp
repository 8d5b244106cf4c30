#include "app/half_space_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sectile::viewer {
namespace {

using Doubles = std::array<double, 3>;

double reach_of(const Solid& solid) {
  double reach = 1;
  for (const Vec3& p : solid.to_mesh().positions)
    reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  // A power of two: sums and products with it are exact for small whole coefficients.
  return std::exp2(std::ceil(std::log2(reach)) + 3);
}

bool lies_in(const HalfSpace& h, const Doubles& p) {
  return h.a * p[0] + h.b * p[1] + h.c * p[2] + h.d == 0;
}

}  // namespace

std::optional<Solid> half_space_block(const Solid& solid, const HalfSpace& plane, bool above) {
  const Doubles n{plane.a, plane.b, plane.c};
  std::size_t major = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i]) > std::abs(n[major])) major = i;
  const std::size_t u = (major + 1) % 3, v = (major + 2) % 3;
  const double reach = reach_of(solid);
  const double side = (n[major] > 0) == above ? 1 : -1;
  PolygonMesh mesh;
  for (const bool far : {false, true})
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      Doubles p{};
      p[u] = x * reach;
      p[v] = y * reach;
      p[major] = -(n[u] * p[u] + n[v] * p[v] + plane.d) / n[major];
      if (!lies_in(plane, p)) return std::nullopt;
      if (far) p[major] += side * 8 * reach;
      mesh.positions.push_back({p[0], p[1], p[2]});
    }
  std::vector<std::array<std::uint32_t, 4>> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (auto& face : faces) {
    if (side < 0) std::reverse(face.begin(), face.end());
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), face.begin(), face.end());
  }
  return Solid::from_mesh(mesh);
}

}  // namespace sectile::viewer
