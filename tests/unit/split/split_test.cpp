// The two parts of a solid that a plane leaves.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "sectile/sectile.h"
#include "unit/split/vectors.h"

namespace sectile {
namespace {

using test::cross, test::difference;

// From short whole numbers: all of it is exact.
struct Plane {
  Vec3 a, b, c;

  Vec3 normal() const { return cross(difference(b, a), difference(c, a)); }
  HalfSpace half_space() const {
    const Vec3 n = normal();
    return {n.x, n.y, n.z, -(n.x * a.x + n.y * a.y + n.z * a.z)};
  }
  // So large a tetrahedron on the plane that it is the half-space for what is near the origin.
  Solid as_solid() const {
    constexpr double far = 4096;
    const Vec3 n = normal(), u = difference(b, a), v = cross(n, u);
    const auto at = [&](double along, double across, double up) {
      return Vec3{a.x + far * (along * u.x + across * v.x + up * n.x),
                  a.y + far * (along * u.y + across * v.y + up * n.y),
                  a.z + far * (along * u.z + across * v.z + up * n.z)};
    };
    PolygonMesh mesh;
    mesh.positions = {at(2, 0, 0), at(-1, 2, 0), at(-1, -2, 0), at(0, 0, 2)};
    mesh.face_sizes = {3, 3, 3, 3};
    mesh.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    return Solid::from_mesh(mesh);
  }
};

const Plane planes[] = {{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}},  {{0, 0, 0}, {1, 1, 0}, {0, 0, 1}},
                        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                        {{0, 0, 1}, {3, 1, 1}, {0, 2, 2}},  {{2, 1, 0}, {1, 2, 0}, {3, 2, 5}},
                        {{0, 0, 2}, {1, 0, 2}, {0, -1, 2}}, {{-1, 0, 0}, {0, 3, 1}, {2, 1, -3}}};

Solid two_cubes_with_an_edge_in_common() {
  return boolean(block({0, 0, 0}, {1, 1, 2}), block({1, 1, 0}, {2, 2, 2}), Operation::unite);
}

std::vector<Solid> solids() {
  const Solid cube = block({0, 0, 0}, {2, 2, 2});
  return {cube,
          boolean(cube, block({1, 1, 1}, {3, 3, 3}), Operation::subtract),
          boolean(block({-1, -1, -1}, {3, 3, 3}), cube, Operation::subtract),
          two_cubes_with_an_edge_in_common(),
          sphere(2, 24, 12),
          torus(2, 0.75, 16, 8),
          transformed(sphere(2, 48, 24), Transform::rotation_degrees({1, 2, 3}, 40))};
}

void expect_legal(const Solid& solid) {
  EXPECT_TRUE(validate(solid).empty());
}

TEST(Split, PartsAreThoseOfBooleansWithAHalfSpace) {
  for (const Solid& solid : solids())
    for (const Plane& plane : planes) {
      const Solid half_space = plane.as_solid();
      const auto [above, below] = split(solid, plane.half_space());
      expect_legal(above);
      expect_legal(below);
      EXPECT_EQ(above, boolean(solid, half_space, Operation::intersect));
      EXPECT_EQ(below, boolean(solid, half_space, Operation::subtract));
      EXPECT_EQ(boolean(above, below, Operation::unite), solid);
      EXPECT_TRUE(boolean(above, below, Operation::intersect).is_empty());
    }
}

TEST(Split, ThroughTheMiddleLeavesTwoHalves) {
  const auto [above, below] = split(block({0, 0, 0}, {2, 4, 6}), {0, 0, 1, -3});
  EXPECT_EQ(above, block({0, 0, 3}, {2, 4, 6}));
  EXPECT_EQ(below, block({0, 0, 0}, {2, 4, 3}));
}

TEST(Split, ThroughTwoEdgesLeavesPrisms) {
  const auto [above, below] = split(block({0, 0, 0}, {1, 1, 1}), {1, -1, 0, 0});
  for (const Solid& part : {above, below}) {
    EXPECT_EQ(part.volume(), 0.5);
    EXPECT_EQ(part.counts().faces, 5u);
    EXPECT_EQ(part.counts().vertices, 6u);
  }
}

TEST(Split, ThroughThreeCornersLeavesACorner) {
  const auto [above, below] = split(block({0, 0, 0}, {2, 2, 2}), {1, 1, 1, -2});
  EXPECT_EQ(below.counts().faces, 4u);
  EXPECT_EQ(below.counts().vertices, 4u);
  EXPECT_EQ(above.counts().faces, 7u);
  EXPECT_EQ(above.counts().vertices, 7u);
  EXPECT_DOUBLE_EQ(below.volume(), 4.0 / 3);
}

TEST(Split, AlongAFaceOrBesideASolidLeavesItWhole) {
  const Solid cube = block({0, 0, 0}, {1, 1, 1});
  const HalfSpace along_faces[] = {{0, 0, 1, 0}, {0, -1, 0, 1}}, around[] = {{1, 0, 0, 1}},
                  at_an_edge[] = {{1, 1, 0, 0}}, at_a_corner[] = {{-1, -1, -1, 3}};
  for (const std::span<const HalfSpace> some :
       {std::span<const HalfSpace>(along_faces), {around}, {at_an_edge}, {at_a_corner}})
    for (const HalfSpace& h : some) {
      const auto [above, below] = split(cube, h);
      EXPECT_EQ(above, cube);
      EXPECT_EQ(above.counts().vertices, 8u);
      EXPECT_TRUE(below.is_empty());
      const auto [behind, before] = split(cube, {-h.a, -h.b, -h.c, -h.d});
      EXPECT_TRUE(behind.is_empty());
      EXPECT_EQ(before, cube);
    }
}

// The common edge lies in the plane: each part has one of the cubes, or half of both.
TEST(Split, ThroughTheLineInWhichASolidTouchesItself) {
  const Solid solid = two_cubes_with_an_edge_in_common();
  const auto [far, near] = split(solid, {1, 1, 0, -2});
  EXPECT_EQ(near, block({0, 0, 0}, {1, 1, 2}));
  EXPECT_EQ(far, block({1, 1, 0}, {2, 2, 2}));
  const auto [right, left] = split(solid, {1, -1, 0, 0});
  EXPECT_EQ(right.volume(), 2);
  EXPECT_EQ(left.volume(), 2);
  EXPECT_EQ(right.counts().shells, 2u);
}

// Cells that touch along edges and in corners, and planes through all of them.
TEST(Split, OfAChequeredCube) {
  std::vector<Solid> cells;
  for (int i = 0; i < 27; i += 2) {
    const double x = i % 3, y = i / 3 % 3, z = i / 9;
    cells.push_back(block({x, y, z}, {x + 1, y + 1, z + 1}));
  }
  const Solid solid = unite(cells);
  for (const Plane& plane : planes) {
    const auto [above, below] = split(solid, plane.half_space());
    expect_legal(above);
    expect_legal(below);
    EXPECT_EQ(above, boolean(solid, plane.as_solid(), Operation::intersect));
    EXPECT_EQ(boolean(above, below, Operation::unite), solid);
  }
}

TEST(Split, IsRefusedWithoutANormalOrWithNumbersThatAreNone) {
  const Solid cube = block({0, 0, 0}, {1, 1, 1});
  constexpr double infinite = std::numeric_limits<double>::infinity(),
                   none = std::numeric_limits<double>::quiet_NaN();
  for (const HalfSpace& h : {HalfSpace{0, 0, 0, 1}, HalfSpace{infinite, 0, 1, 0},
                             HalfSpace{0, none, 1, 0}, HalfSpace{0, 0, 1, -infinite}}) {
    EXPECT_THROW(split(cube, h), std::invalid_argument);
    EXPECT_THROW(split(Solid(), h), std::invalid_argument);
    EXPECT_THROW(section(cube, h), std::invalid_argument);
  }
}

TEST(Split, OfNothingIsNothing) {
  const auto [above, below] = split(Solid(), {0, 0, 1, 0});
  EXPECT_TRUE(above.is_empty());
  EXPECT_TRUE(below.is_empty());
}

}  // namespace
}  // namespace sectile
