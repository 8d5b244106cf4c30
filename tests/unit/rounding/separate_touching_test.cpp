// Solids that touch themselves, written as manifolds.
#include <gtest/gtest.h>

#include "unit/manifold_check.h"
#include "unit/rounding/legal_rounding.h"

namespace sectile::test {
namespace {

// Everything moves by steps only, and what does not touch stays.
void expect_manifold(const Solid& solid, std::size_t least_separated) {
  for (const Numbers numbers : {Numbers::doubles, Numbers::floats, Numbers::grid}) {
    Rounding rounding = to(numbers, 0x1p-12);
    rounding.separate_touching = true;
    const RoundedMesh rounded = expect_legal(solid, rounding);
    EXPECT_EQ(manifold_fault(rounded.mesh), "");
    EXPECT_GE(rounded.report.separated, least_separated);
    const double step = numbers == Numbers::grid ? 0x1p-12 : unit_of(rounded.mesh, numbers);
    EXPECT_LE(rounded.report.largest_move, 64 * step);
  }
}

Solid two_cubes(const Vec3& low) {
  return boolean(block({0, 0, 0}, {1, 1, 1}), block(low, {low.x + 1, low.y + 1, low.z + 1}),
                 Operation::unite);
}

TEST(SeparateTouching, CubesWithACommonCorner) {
  const Solid cubes = two_cubes({1, 1, 1});
  EXPECT_NE(manifold_fault(rounded_mesh(cubes).mesh), "");
  expect_manifold(cubes, 1);
  expect_manifold(turned(cubes, 0.4), 1);
}

TEST(SeparateTouching, CubesWithACommonEdge) {
  const Solid cubes = two_cubes({1, 1, 0});
  expect_manifold(cubes, 2);
  expect_manifold(turned(cubes, 0.4), 2);
  // No corner and no whole edge in common.
  expect_manifold(two_cubes({1, 1, 0.5}), 0);
}

// Both ends of the edge are in one fan each.
TEST(SeparateTouching, AnEdgeBetweenTwoFloors) {
  const Solid floors =
      boolean(block({-1, -1, -1}, {3, 3, 0}), block({-1, -1, 1}, {3, 3, 2}), Operation::unite);
  const Solid room = boolean(floors, two_cubes({1, 1, 0}), Operation::unite);
  expect_manifold(room, 1);
  expect_manifold(turned(room, 0.3), 1);
}

TEST(SeparateTouching, TheAxisOfAChessBoard) {
  Solid board;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if ((x + y + z) % 2 == 0)
          board =
              boolean(board, block({double(x), double(y), double(z)}, {x + 1.0, y + 1.0, z + 1.0}),
                      Operation::unite);
  expect_manifold(board, 8);
  expect_manifold(turned(board, 0.2), 8);
}

TEST(SeparateTouching, HollowsThatTouch) {
  const Solid body = block({-1, -1, -1}, {3, 3, 3});
  expect_manifold(boolean(body, two_cubes({1, 1, 1}), Operation::subtract), 1);
  expect_manifold(boolean(body, two_cubes({1, 1, 0}), Operation::subtract), 1);
}

// A step away from where two corners touch there is another corner.
TEST(SeparateTouching, GoesToNoPlaceThatIsTaken) {
  const Solid solid = boolean(two_cubes({1, 1, 1}),
                              transformed(two_cubes({1, 1, 1}), Transform::translation({1, 1, 1})),
                              Operation::unite);
  for (const Vec3& at : {Vec3{-1, 1, 2}, Vec3{0, 2, 1}, Vec3{2, 2, 0}, Vec3{1, 0, 2}}) {
    const Solid more = boolean(solid, block(at, {at.x + 1, at.y + 1, at.z + 1}), Operation::unite);
    Rounding rounding = to(Numbers::grid, 1);
    rounding.separate_touching = true;
    EXPECT_EQ(manifold_fault(expect_legal(more, rounding).mesh), "");
  }
}

// What is in one of two tetrahedra only touches itself in many edges and corners, some of which are
// a step from each other.
TEST(SeparateTouching, WhereThereIsNoRoomACoarserGridMakesIt) {
  const Solid a = tetrahedron({2, 1, 1}, {1, 1, 0}, {0, 0, 0}, {0, 1, 0}),
              b = tetrahedron({1, 0, 0}, {2, 1, 2}, {0, 2, 0}, {2, 2, 0});
  const Solid one_only = boolean(boolean(a, b, Operation::subtract),
                                 boolean(b, a, Operation::subtract), Operation::unite);
  Rounding rounding = to(Numbers::grid, 0.5);
  rounding.separate_touching = true;
  const RoundedMesh rounded = expect_legal(one_only, rounding);
  EXPECT_EQ(manifold_fault(rounded.mesh), "");
  EXPECT_FALSE(rounded.mesh.face_sizes.empty());
  // To a place of the grid, then of the coarser one, then a step away.
  EXPECT_LT(rounded.report.largest_move, (1 + 4 + 2) * 0.5 * std::sqrt(3) / 2);
}

// A square one with its tip at (1, 0, 0), towards +y.
Solid pyramid_at_one(double half_width, double height) {
  const double h = half_width;
  const Vec3 tip{1, 0, 0}, a{1 - h, -height, -h}, b{1 + h, -height, -h}, c{1 + h, -height, h},
      d{1 - h, -height, h};
  return boolean(tetrahedron(tip, a, b, c), tetrahedron(tip, c, d, a), Operation::unite);
}

// The tip of a pyramid touches the bottom of a pit, and all of it is far thinner than a step.
TEST(SeparateTouching, WhereOnlySmallCoordinatesHaveRoom) {
  constexpr double w = 0x1p-30;
  const Solid plate =
      boolean(block({0.5, -w, -0.5}, {1.5, w, 0.5}), pyramid_at_one(0.25, w), Operation::subtract);
  const Solid parts[] = {plate, pyramid_at_one(0.25, 2 * w),
                         block({0.5, -3 * w, -0.5}, {1.5, -2 * w, 0.5})};
  Rounding rounding = to(Numbers::floats);
  rounding.separate_touching = true;
  const RoundedMesh rounded = expect_legal(unite(parts), rounding);
  EXPECT_EQ(manifold_fault(rounded.mesh), "");
  EXPECT_EQ(rounded.report.separated, 1u);
  EXPECT_EQ(rounded.report.resolved, 0u);
  EXPECT_LE(rounded.report.largest_move, 2 * w);
}

// Wedges in each other, far thinner than a step, have an edge in common: to tell them apart,
// corners would have to move far. They vanish, and the block that is there with them stays.
TEST(SeparateTouching, WhatIsThinnerThanAStepVanishesFirst) {
  const Vec3 u{0.5014f, -0.2529f, 0.4971f}, v{0.3f, 0.7f, 0.2f};
  Solid wedges;
  for (const double w : {0x1p-60, 0x1p-59, 3 * 0x1p-60, 0x1p-58})
    wedges =
        boolean(tetrahedron(u, v, {-w, w / 2, 0}, {w / 2, 0, -w / 4}), wedges, Operation::subtract);
  const Solid body = block({2, 0, 0}, {3, 1, 1});
  Rounding rounding = to(Numbers::floats);
  EXPECT_NE(manifold_fault(rounded_mesh(wedges, rounding).mesh), "");
  rounding.separate_touching = true;
  const RoundedMesh rounded = rounded_mesh(boolean(body, wedges, Operation::unite), rounding);
  EXPECT_EQ(manifold_fault(rounded.mesh), "");
  EXPECT_EQ(Solid::from_mesh(rounded.mesh), body);
  EXPECT_LE(rounded.report.largest_move, 0x1p-23);
}

TEST(SeparateTouching, LeavesAManifoldAsItIs) {
  Rounding rounding;
  rounding.separate_touching = true;
  const Solid ball = sphere(1, 24, 12);
  const RoundedMesh rounded = rounded_mesh(ball, rounding);
  EXPECT_EQ(rounded.report.separated, 0u);
  EXPECT_EQ(Solid::from_mesh(rounded.mesh), ball);
}

}  // namespace
}  // namespace sectile::test
