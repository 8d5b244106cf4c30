// An operand whose own edges cross in the interior of a face of the other operand, flush with it.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "volumes.h"

namespace sectile {
namespace {

using test::expect_volumes;

// A triangular prism along x or y that touches the plane z = 0 with an edge through the origin,
// from above or below. Volume 4: cross-section 2 × 1 / 2, 4 long.
Solid ridge(double degrees, bool above) {
  Profile triangle;
  triangle.outer = {{0, 0}, {1, 1}, {-1, 1}};
  const Transform upright{{0, 0, 1, -2, 1, 0, 0, 0, 0, 1, 0, 0}};
  Transform place = Transform::rotation_degrees({0, 0, 1}, degrees) * upright;
  if (!above) place = Transform::rotation_degrees({1, 0, 0}, 180) * place;
  return transformed(extrude(triangle, 4), place);
}

Solid crossed_ridges() {
  return boolean(ridge(0, true), ridge(90, false), Operation::unite);
}

// The union of the ridges has a vertex at the crossing; joined as a soup they have none.
Solid as_soup(const std::vector<Solid>& parts) {
  PolygonMesh all;
  for (const Solid& part : parts) {
    const PolygonMesh mesh = part.to_mesh();
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    all.face_sizes.insert(all.face_sizes.end(), mesh.face_sizes.begin(), mesh.face_sizes.end());
    for (const std::uint32_t i : mesh.indices) all.indices.push_back(first + i);
  }
  return Solid::from_mesh(all);
}

TEST(CrossingEdges, OfTwoRidges) {
  const Solid a = as_soup({ridge(0, true), ridge(90, false)});
  EXPECT_EQ(a.volume(), 8);
  EXPECT_EQ(a, crossed_ridges());
  expect_volumes(a, block({-3, -3, 0}, {3, 3, 2}), 4);
  expect_volumes(a, block({-3, -3, -2}, {3, 3, 0}), 4);
  expect_volumes(a, block({-3, -3, -2}, {3, 3, 2}), 8);
  expect_volumes(a, block({-3, -3, 0}, {3, 0, 2}), 2);
  expect_volumes(a, block({0, 0, 0}, {3, 3, 2}), 1);
  expect_volumes(a, crossed_ridges(), 8);
}

TEST(CrossingEdges, InThePlaneOfASplit) {
  const Solid a = as_soup({ridge(0, true), ridge(90, false)});
  const auto [above, below] = split(a, HalfSpace{0, 0, 1, 0});
  EXPECT_EQ(above.volume(), 4);
  EXPECT_EQ(below.volume(), 4);
  EXPECT_TRUE(validate(above).empty());
  EXPECT_TRUE(validate(below).empty());
}

TEST(CrossingEdges, OfRowsOfRidges) {
  std::vector<Solid> ridges;
  for (const double at : {-1.5, 0.0, 1.5}) {
    const auto scaled = Transform::scaling({1, 0.5, 1});
    ridges.push_back(transformed(ridge(0, true), Transform::translation({0, at, 0}) * scaled));
    ridges.push_back(transformed(ridge(0, false), Transform::rotation_degrees({0, 0, 1}, 90) *
                                                      Transform::translation({0, at, 0}) * scaled));
  }
  const Solid grid = as_soup(ridges);
  EXPECT_EQ(grid.volume(), 12);
  expect_volumes(grid, block({-3, -3, 0}, {3, 3, 2}), 6);
  expect_volumes(grid, block({-3, -3, -2}, {3, 3, 0}), 6);
  expect_volumes(grid, block({-3, -3, -2}, {3, 1.5, 0}), 5.25);
  const Solid bored = boolean(block({-3, -3, 0}, {3, 3, 2}), block({-0.5, -0.5, -1}, {0.5, 0.5, 3}),
                              Operation::subtract);
  const double common = boolean(grid, bored, Operation::intersect).volume();
  EXPECT_GT(common, 5);
  expect_volumes(grid, bored, common);
}

}  // namespace
}  // namespace sectile
