// Pages of books around the z axis, and slits in them, with coordinates that are whole numbers.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "sectile/sectile.h"

namespace sectile::test {

// The half-planes through these points on the rim of a square, in a turn.
inline std::array<double, 2> on_square(int at) {
  constexpr int half = 24, side = 2 * half;
  const int along = at % side - half;
  const std::array<double, 2> corners[] = {{double(half), double(along)},
                                           {double(-along), double(half)},
                                           {double(-half), double(-along)},
                                           {double(along), double(-half)}};
  return corners[at / side % 4];
}

struct Leaf {
  int first, second;  // half-planes
  int low, high;
  bool inside_out = false;
};

inline void add_leaf(const Leaf& leaf, bool sheared, PolygonMesh& mesh) {
  const auto o = static_cast<std::uint32_t>(mesh.positions.size());
  for (const int z : {leaf.low, leaf.high}) {
    const double shift = sheared ? 2 * z : 0;
    mesh.positions.push_back({shift, 0, 16.0 * z});
    for (const int at : {leaf.first, leaf.second}) {
      const auto [x, y] = on_square(at);
      mesh.positions.push_back({x + shift, y, 16.0 * z});
    }
  }
  std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                                                  {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  for (auto [a, b, c] : faces) {
    if (leaf.inside_out) std::swap(b, c);
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {o + a, o + b, o + c});
  }
}

inline bool is_accepted(const PolygonMesh& mesh) {
  try {
    Solid::from_mesh(mesh);
    return true;
  } catch (const InvalidSolid&) {
    return false;
  }
}

}  // namespace sectile::test
