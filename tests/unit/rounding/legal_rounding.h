// Solids are written and read back, and judged by a checker that knows nothing of the library.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sectile/repair.h"
#include "sectile/rounding.h"
#include "sectile/sectile.h"
#include "unit/exact_mesh_checker.h"
#include "unit/same_shape.h"

namespace sectile::test {

using Numbers = Rounding::Numbers;

inline Rounding to(Numbers numbers, double spacing = 1) {
  Rounding rounding;
  rounding.numbers = numbers;
  rounding.spacing = spacing;
  return rounding;
}

// A unit in the last place of the largest coordinate.
inline double unit_of(const PolygonMesh& mesh, Numbers numbers) {
  double size = 0;
  for (const Vec3& p : mesh.positions)
    size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return numbers == Numbers::floats ? size * 0x1p-23 : size * 0x1p-52;
}

inline RoundedMesh expect_legal(const Solid& solid, const Rounding& rounding) {
  RoundedMesh rounded = rounded_mesh(solid, rounding);
  EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
  EXPECT_EQ(shape_fault(solid, rounded), "");
  EXPECT_EQ(rounded.sources.size(), rounded.mesh.face_sizes.size());
  if (rounding.numbers == Numbers::floats) {
    for (const Vec3& p : rounded.mesh.positions)
      for (const double c : {p.x, p.y, p.z})
        EXPECT_EQ(c, static_cast<double>(static_cast<float>(c)));
  }
  const bool vanishes = rounded.mesh.positions.empty();
  if (rounding.numbers != Numbers::grid && rounded.report.resolved == 0 && !vanishes) {
    EXPECT_LE(rounded.report.median_move, 1.8 * unit_of(rounded.mesh, rounding.numbers));
  }
  return rounded;
}

inline Solid turned(const Solid& solid, double angle, double tilt = 0.3) {
  return transformed(solid, Transform::rotation_degrees({1, tilt, 0.7}, angle * 57.29577951308232));
}

inline Solid tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  PolygonMesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.face_sizes = {3, 3, 3, 3};
  mesh.indices = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  return repair(mesh);
}

}  // namespace sectile::test
