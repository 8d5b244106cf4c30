// Walls whose edges all run through one point, each in a direction of its own.
//
// Seen from the point each wall is a sector of half a turn from one end of its edge to the other.
// The edges lie in a cone around the z-axis, and the walls leave them sideways, so that all are
// turned alike and no two meet in more than the point.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "cases.h"
#include "sectile/mesh.h"

namespace sectile::test {

struct WallsThroughAPoint {
  int count = cases(72);
  double turn = 0;         ///< of all, by so much of the step from one to the next
  double thickness = 0.3;  ///< as part of the room
  double depth = 1;        ///< from the edge on
  double off = 0;          ///< how far they begin from the point
  bool mirrored = false;   ///< inclined the other way around

  /// From end to end of the edge, and two at the other side.
  std::array<Vec3, 4> corners(int i) const {
    constexpr double size = 1 << 20, incline = 0.7;
    const double a = 2 * std::numbers::pi * (i + turn) / count, x = std::cos(a), y = std::sin(a),
                 beside = (mirrored ? -1 : 1) * std::sin(incline), up = std::cos(incline);
    const Vec3 end{std::round(-size * beside * y), std::round(size * beside * x),
                   std::round(size * up)};
    const double far = size * depth,
                 wide = far * std::tan(thickness * std::numbers::pi / count * up);
    const auto at = [&](double side) -> Vec3 {
      return {far * x - side * wide * up * y, far * y + side * wide * up * x,
              -side * wide * beside};
    };
    std::array<Vec3, 4> all{Vec3{-end.x, -end.y, -end.z}, end, at(1), at(-1)};
    for (Vec3& p : all) p = {p.x + off * x, p.y + off * y, p.z};
    return all;
  }
  void add(int i, PolygonMesh& mesh) const {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : corners(i)) mesh.positions.push_back(p);
    for (const auto& face : {std::array{0u, 3u, 1u}, {0u, 2u, 3u}, {0u, 1u, 2u}, {1u, 3u, 2u}}) {
      mesh.face_sizes.push_back(3);
      for (const std::uint32_t corner : face) mesh.indices.push_back(first + corner);
    }
  }
  PolygonMesh mesh() const {
    PolygonMesh mesh;
    for (int i = 0; i < count; ++i) add(i, mesh);
    return mesh;
  }
};

}  // namespace sectile::test
