// Placements that make solids touch and line up.
#include "scene/placing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sectile::viewer {
namespace {

std::vector<ExactCorner> exactly(const std::vector<Vec3>& points) {
  std::vector<ExactCorner> made;
  for (const Vec3& point : points) made.push_back({point});
  return made;
}

/// The corners of the face of the block [-1, 1]³ whose normal is this axis.
std::vector<Vec3> block_corners(int axis, double side) {
  std::vector<Vec3> corners;
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const double c[3]{side, double(u), double(v)};
    corners.push_back({c[(3 - axis) % 3], c[(4 - axis) % 3], c[(5 - axis) % 3]});
  }
  return corners;
}

std::vector<ExactCorner> block_face(int axis, double side) {
  return exactly(block_corners(axis, side));
}

Standing at(const Vec3& position, const Vec3& rotation = {}) {
  return {{position, rotation, {1, 1, 1}}, {}, {}};
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Placing, FlushMovesAlongTheNormalOnly) {
  const Standing start = at({0.3, 0.1, 7.7});
  const Landing landed = flush(start, {{0, 0, -1}, block_face(2, -1)},
                               {{0, 0, 1}, exactly({{-5, -5, 0.1}, {5, -5, 0.1}, {5, 5, 0.1}})});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position.x, 0.3);
  EXPECT_EQ(landed.placement.position.y, 0.1);
  EXPECT_EQ(landed.placement.position.z, 1.1);
  EXPECT_NE(landed.placement.remainder.z, 0) << "0.1 + 1 is no double";
  EXPECT_EQ(landed.placement.remainder.x, 0);
}

TEST(Placing, FlushTurnsByRightAnglesExactly) {
  // The face to the right comes to lie on a floor.
  const Standing start = at({3, 4, 5});
  const Landing landed =
      flush(start, {{1, 0, 0}, block_face(0, 1)},
            {{0, 0, 1}, exactly({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}})});
  EXPECT_TRUE(landed.is_exact);
  for (const Vec3& corner : block_corners(0, 1))
    EXPECT_EQ(start.with(landed.placement).image(corner).z, 0);
  EXPECT_EQ(start.with(landed.placement).image({-1, 0, 0}).z, 2);
}

TEST(Placing, CentredFacesHaveTheirMiddlesInOnePlace) {
  const FlatFace floor{{0, 0, 1},
                       exactly({{1, 2, 0.25}, {5, 2, 0.25}, {5, 9, 0.25}, {1, 9, 0.25}})};
  const Standing start = at({0.7, -3, 5}, {0, 0, 90});
  const Landing landed = flush(start, {{0, 0, -1}, block_face(2, -1)}, floor, {true, false});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position, (Vec3{3, 5.5, 1.25}));
}

TEST(Placing, MiddlesBetweenTwoDoublesAreReachedBySums) {
  const double high = std::nextafter(1.5, 2);
  const FlatFace floor{{0, 0, 1}, exactly({{1, 1, 0}, {high, 1, 0}, {high, 4, 0}, {1, 4, 0}})};
  const Landing landed =
      flush(at({0.1, 0, 5}), {{0, 0, -1}, block_face(2, -1)}, floor, {true, false});
  EXPECT_TRUE(landed.is_exact);
  expect_near(landed.placement.position, {1.25, 2.5, 1});
  EXPECT_EQ(std::abs(landed.placement.remainder.x), 0x1p-53);
}

TEST(Placing, WhatTwoDoublesCannotCentreIsSaidNotToBeExact) {
  // Bits too far apart.
  const double high = 0x1p-150;
  const FlatFace floor{
      {0, 0, 1}, exactly({{1 + 0x1p-52, 1, 0}, {high, 1, 0}, {high, 4, 0}, {1 + 0x1p-52, 4, 0}})};
  const Landing landed =
      flush(at({0.1, 0, 5}), {{0, 0, -1}, exactly({{-1, -1, -1}, {0x1p-90, 1, -1}})}, floor,
            {true, false});
  EXPECT_FALSE(landed.is_exact);
}

// The plane of a face at 1 + 0.1, which is no double: the remainder of the one placement must be
// met by that of the other.
TEST(Placing, FlushOnASolidThatStandsBetweenDoubles) {
  Standing below = at({0, 0, 0.1});
  const FlatFace top{{0, 0, 1}, block_face(2, 1), below.exact_map()};
  const Landing landed = flush(at({0, 0, 7}), {{0, 0, -1}, block_face(2, -1)}, top);
  EXPECT_TRUE(landed.is_exact);
  const Solid cube = block({-1, -1, -1}, {1, 1, 1});
  const Solid both = boolean(transformed(cube, landed.placement.exact()),
                             transformed(cube, below.exact_map()), Operation::unite);
  EXPECT_EQ(both.counts().shells, 1u);
  EXPECT_EQ(both.volume(), 16);
  EXPECT_EQ(both.counts().faces, 6u) << "nothing of the contact is left";
}

// Turned corners are no doubles: what rounds to the target need not lie there.
TEST(Placing, TurnedCornersAreJudgedByTheirExactPlace) {
  int exact = 0, rounded = 0;
  const ExactSum corner({}, {{1, 1, 1}});
  for (int i = 1; i < 200; ++i) {
    const Standing start = at({0, 0, 0}, {0, 0, 0.45 * i});
    const ExactSum target = ExactSum::of({3, 0, 0});
    const Coordinates x{true, false, false};
    Landing landed = moved_onto(start.placement, {}, corner, target, x);
    EXPECT_TRUE(landed.is_exact) << "sums of two entries of the matrix fit into two doubles";
    EXPECT_TRUE(are_equal(corner.mapped(landed.placement.exact()), target, x));
    landed.placement.remainder = {0, 0, 0};
    exact += are_equal(corner.mapped(landed.placement.exact()), target, x);
    rounded += start.with(landed.placement).image({1, 1, 1}).x == 3;
  }
  EXPECT_GT(rounded, 150);
  EXPECT_LT(exact, 50);
}

TEST(Placing, SameSideIsLevel) {
  const Landing landed =
      flush(at({0, 0, 5}), {{0, 0, 1}, block_face(2, 1)},
            {{0, 0, 1}, exactly({{-5, -5, 3}, {5, -5, 3}, {5, 5, 3}})}, {false, true});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position, (Vec3{0, 0, 2}));
  EXPECT_EQ(landed.placement.rotation, Vec3());
}

TEST(Placing, SlantedFacesAreMetNearly) {
  const double half = std::sqrt(0.5);
  const FlatFace slope{{half, 0, half}, exactly({{0, 0, 2}, {2, 0, 0}, {2, 4, 0}, {0, 4, 2}})};
  const Standing start = at({9, 9, 9});
  const Landing landed = flush(start, {{0, 0, -1}, block_face(2, -1)}, slope, {true, false});
  EXPECT_FALSE(landed.is_exact);
  const Standing there = start.with(landed.placement);
  for (const Vec3& corner : block_corners(2, -1)) {
    const Vec3 p = there.image(corner);
    EXPECT_NEAR(p.x + p.z, 2, 1e-12);
  }
  expect_near(there.image({0, 0, -1}), {1, 2, 1});
}

TEST(Placing, EdgesLieOnEachOther) {
  const Standing start = at({5, 0, 0});
  // An edge along y goes onto one along x.
  const Landing landed =
      edge_on_edge(start, {{{1, -1, 1}}, {{1, 1, 1}}}, {{{0.5, 3, 0.125}}, {{9, 3, 0.125}}});
  EXPECT_TRUE(landed.is_exact);
  const Standing there = start.with(landed.placement);
  EXPECT_EQ(there.image({1, -1, 1}), (Vec3{0.5, 3, 0.125}));
  EXPECT_EQ(there.image({1, 1, 1}), (Vec3{2.5, 3, 0.125}));
}

TEST(Placing, BoxesAlign) {
  ExactBox box;
  box.add(at({0.1, 0, 0}), exactly({{-1, -1, -1}, {1, 1, 1}, {0, 3, 0}}));
  EXPECT_EQ(box.high(1).value, 3);
  const auto value = [](double x) { return ExactSum::of({x, x, x}); };
  const Landing ground = aligned(box, 2, BoxPlace::low, value(0));
  EXPECT_TRUE(ground.is_exact);
  EXPECT_EQ(ground.placement.position, (Vec3{0.1, 0, 1}));
  const Landing middle = centred(box, 1, value(10), value(20));
  EXPECT_TRUE(middle.is_exact);
  EXPECT_EQ(middle.placement.position, (Vec3{0.1, 14, 0}));
  EXPECT_EQ(aligned(box, 0, BoxPlace::high, value(5)).placement.position.x, 4);
}

TEST(Placing, ABoxKnowsWhichOfTwoCornersThatRoundAlikeReachesFarther) {
  Standing left = at({1, 0, 0});
  left.placement.remainder.x = 0x1p-80;
  for (const bool first : {true, false}) {
    ExactBox box;
    for (const bool is_left : {first, !first})
      box.add(is_left ? left : at({1, 0, 0}), exactly({{0, 0, 0}}));
    EXPECT_EQ(box.high(0).standing.placement.remainder.x, 0x1p-80);
    EXPECT_EQ(box.low(0).standing.placement.remainder.x, 0);
  }
}

TEST(Placing, InATurnedParentTheWorldCounts) {
  Standing standing = at({1, 2, 3});
  standing.parent = Transform::rotation_degrees({0, 0, 1}, 90);
  ExactBox box;
  box.add(standing, block_face(2, -1));
  const Landing landed = aligned(box, 0, BoxPlace::low, ExactSum::of({7, 7, 7}));
  EXPECT_TRUE(landed.is_exact);
  for (const Vec3& corner : block_corners(2, -1))
    EXPECT_GE(standing.with(landed.placement).image(corner).x, 7);
  EXPECT_EQ(standing.with(landed.placement).image({1, 1, -1}).x, 7);
}

}  // namespace
}  // namespace sectile::viewer
