// Coordinates at both ends of the doubles, where bounds of rounding errors underflow and overflow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr double least = 0x1p-1074;

Solid tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const PolygonMesh mesh{{a, b, c, d}, {3, 3, 3, 3}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
  PolygonMesh turned = mesh;
  std::reverse(turned.indices.begin(), turned.indices.end());
  try {
    return Solid::from_mesh(mesh);
  } catch (const InvalidSolid&) {
    return Solid::from_mesh(turned);
  }
}

// Both halves are legal, and together the solid.
void expect_halves(const Solid& solid, const HalfSpace& half_space) {
  const auto [above, below] = split(solid, half_space);
  EXPECT_TRUE(validate(above).empty());
  EXPECT_TRUE(validate(below).empty());
  EXPECT_FALSE(above.is_empty());
  EXPECT_FALSE(below.is_empty());
  EXPECT_TRUE(boolean(above, below, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(above, below, Operation::unite) == solid);
}

// What two solids share and what only the first one has are legal and make up the first one.
void expect_all_results(const Solid& a, const Solid& b) {
  const Solid both = boolean(a, b, Operation::intersect);
  const Solid alone = boolean(a, b, Operation::subtract);
  const Solid together = boolean(a, b, Operation::unite);
  for (const Solid& s : {both, alone, together}) EXPECT_TRUE(validate(s).empty());
  EXPECT_TRUE(boolean(both, alone, Operation::unite) == a);
  EXPECT_TRUE(boolean(alone, b, Operation::unite) == together);
}

TEST(WrongSignNearSubnormals, ABlockSplitByShortCoefficients) {
  expect_halves(block({0, 0, 0}, {1, 1, 1}), {0x1p-540, 0, -0x1p-540, 0});
}

TEST(WrongSignNearSubnormals, ABlockSplitByLongCoefficients) {
  expect_halves(block({0, 0, 0}, {1, 1, 1}), {0x1p540, 0, -0x1p540, 0});
  expect_halves(block({0, 0, 0}, {1, 1, 1}), {0x1p1022, 0x1p1022, 0x1p1022, -0x1p1023});
}

TEST(WrongSignNearSubnormals, TetrahedraWithCornersOfTheLeastDoubles) {
  for (const double e : {least, 0x1p-1022, 0x1p-540, 0x1p-200}) {
    const Solid a = tetrahedron({2 * e, 0, e}, {4 * e, 4, 2 * e}, {4, 0, 0}, {0, 0, 4});
    const Solid b = tetrahedron({0, -4, 0}, {8, -4, 4}, {0, 16, 0}, {16, 0, 0});
    const HalfSpace upper{0, 1, 0, -2};
    expect_halves(a, upper);
    expect_halves(b, upper);
    const auto [above_a, below_a] = split(a, upper);
    const auto [above_b, below_b] = split(b, upper);
    for (const Solid& s : {above_a, below_a})
      for (const Solid& t : {b, above_b, below_b}) expect_all_results(s, t);
    for (const Solid& t : {above_b, below_b}) expect_all_results(a, t);
  }
}

TEST(WrongSignNearSubnormals, TetrahedraOfAllSizes) {
  for (const double e : {least, 0x1p-1022, 0x1p-540, 1.0, 0x1p540, 0x1p1018}) {
    const Solid solid =
        tetrahedron({0, -4 * e, 0}, {8 * e, -4 * e, 4 * e}, {0, 16 * e, 0}, {16 * e, 0, 0});
    expect_halves(solid, {0, 1, 0, -2 * e});
    expect_halves(solid, {1, 1, 0, -3 * e});
  }
}

// Slanted boxes and cavities in turn, one in the other, from a size on whose areas are no numbers.
PolygonMesh nested_shells(double size) {
  PolygonMesh mesh;
  for (int i = 0; i < 40; ++i) {
    const double r = i < 20 ? size / (1 + i) : 2.5 - (i - 20) / 16.0;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double z : {-r, r})
      for (const double y : {-r, r})
        for (const double x : {-r, r}) mesh.positions.push_back({x - 3 * y, 2 * x + y, z});
    for (const std::array<std::uint32_t, 4>& f : {std::array{0u, 2u, 3u, 1u},
                                                  {4u, 5u, 7u, 6u},
                                                  {0u, 1u, 5u, 4u},
                                                  {2u, 6u, 7u, 3u},
                                                  {0u, 4u, 6u, 2u},
                                                  {1u, 3u, 7u, 5u}}) {
      mesh.face_sizes.push_back(4);
      for (std::size_t k = 0; k < 4; ++k) mesh.indices.push_back(first + f[i % 2 == 0 ? k : 3 - k]);
    }
  }
  return mesh;
}

TEST(ExtremeCoordinates, SplitOfNestedShellsWhoseAreasOverflow) {
  for (const double size : {1e3, 1e154, 1e155, 1e200, 1e300}) {
    SCOPED_TRACE(size);
    const auto [above, below] = split(Solid::from_mesh(nested_shells(size)), {0, 0, 1, -0.25});
    EXPECT_TRUE(validate(above).empty());
    EXPECT_TRUE(validate(below).empty());
  }
}

}  // namespace
}  // namespace sectile
