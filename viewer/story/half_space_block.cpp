#include "story/half_space_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sectile::viewer {
namespace {

using Doubles = std::array<double, 3>;

// The block's corners lie on a coarse grid around the solid: sums and products with them are exact
// for small whole coefficients.
struct Reach {
  double grid = 1;
  Doubles low{}, high{};

  explicit Reach(const Solid& solid) {
    const std::vector<Vec3> positions = solid.to_mesh().positions;
    double farthest = 0;
    for (const Vec3& p : positions)
      farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    grid = std::exp2(std::ceil(std::log2(farthest)) - 4);
    low.fill(farthest), high.fill(-farthest);
    for (const Vec3& p : positions) {
      const Doubles at{p.x, p.y, p.z};
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], at[i]);
        high[i] = std::max(high[i], at[i]);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::floor(low[i] / grid) - 1) * grid;
      high[i] = (std::ceil(high[i] / grid) + 1) * grid;
    }
  }
};

bool lies_in(const HalfSpace& h, const Doubles& p) {
  return h.a * p[0] + h.b * p[1] + h.c * p[2] + h.d == 0;
}

std::size_t longest_of(const Doubles& n) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i]) > std::abs(n[longest])) longest = i;
  return longest;
}

}  // namespace

std::optional<Solid> half_space_block(const Solid& solid, const HalfSpace& plane, bool above) {
  if (solid.is_empty()) return std::nullopt;
  const Doubles n{plane.a, plane.b, plane.c};
  const std::size_t major = longest_of(n), u = (major + 1) % 3, v = (major + 2) % 3;
  const Reach reach(solid);
  const bool upwards = (n[major] > 0) == above;
  std::array<Doubles, 4> cut{};
  double end = upwards ? reach.high[major] : reach.low[major];
  for (std::size_t i = 0; i < 4; ++i) {
    Doubles& p = cut[i];
    p[u] = i == 0 || i == 3 ? reach.low[u] : reach.high[u];
    p[v] = i < 2 ? reach.low[v] : reach.high[v];
    p[major] = -(n[u] * p[u] + n[v] * p[v] + plane.d) / n[major];
    if (!lies_in(plane, p)) return std::nullopt;
    end = upwards ? std::max(end, (std::ceil(p[major] / reach.grid) + 1) * reach.grid)
                  : std::min(end, (std::floor(p[major] / reach.grid) - 1) * reach.grid);
  }
  PolygonMesh mesh;
  for (const bool far : {false, true})
    for (Doubles p : cut) {
      if (far) p[major] = end;
      mesh.positions.push_back({p[0], p[1], p[2]});
    }
  std::vector<std::array<std::uint32_t, 4>> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (auto& face : faces) {
    if (!upwards) std::reverse(face.begin(), face.end());
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), face.begin(), face.end());
  }
  return Solid::from_mesh(mesh);
}

}  // namespace sectile::viewer
