// Long thin slanted triangles, which boxes do not tell apart.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

#include "sectile/sectile.h"

namespace sectile::test {

/// A twisted prism: two needles from end to end for each of its sides.
inline Solid needles(std::size_t count, double radius, double half_height, double twist) {
  const auto sides = static_cast<std::uint32_t>(count);
  PolygonMesh mesh;
  for (const double end : {-1.0, 1.0})
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides + end * twist / 2;
      mesh.positions.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), end * half_height});
    }
  const auto add = [&](std::initializer_list<std::uint32_t> corners) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    mesh.indices.insert(mesh.indices.end(), corners);
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    add({i, j, sides + i});
    add({j, sides + j, sides + i});
  }
  for (const bool top : {false, true}) {
    mesh.face_sizes.push_back(sides);
    for (std::uint32_t i = 0; i < sides; ++i)
      mesh.indices.push_back(top ? sides + i : sides - 1 - i);
  }
  ImportOptions options;
  options.trusted = true;
  return Solid::from_mesh(mesh, options);
}

}  // namespace sectile::test
