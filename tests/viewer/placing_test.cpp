// Placements that make solids touch and line up.
#include "scene/placing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sectile::viewer {
namespace {

/// The corners of the face of the block [-1, 1]³ whose normal is this axis.
std::vector<Vec3> block_face(int axis, double side) {
  std::vector<Vec3> corners;
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const double c[3]{side, double(u), double(v)};
    corners.push_back({c[(3 - axis) % 3], c[(4 - axis) % 3], c[(5 - axis) % 3]});
  }
  return corners;
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
                               {{0, 0, 1}, {{-5, -5, 0.7}, {5, -5, 0.7}, {5, 5, 0.7}}});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position.x, 0.3);
  EXPECT_EQ(landed.placement.position.y, 0.1);
  EXPECT_EQ(landed.placement.position.z - 1, 0.7) << "rounded as the evaluator does it";
}

TEST(Placing, FlushTurnsByRightAnglesExactly) {
  // The face to the right comes to lie on a floor.
  const Standing start = at({3, 4, 5});
  const Landing landed = flush(start, {{1, 0, 0}, block_face(0, 1)},
                               {{0, 0, 1}, {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  EXPECT_TRUE(landed.is_exact);
  for (const Vec3& corner : block_face(0, 1))
    EXPECT_EQ(start.with(landed.placement).image(corner).z, 0);
  EXPECT_EQ(start.with(landed.placement).image({-1, 0, 0}).z, 2);
}

TEST(Placing, CentredFacesHaveTheirMiddlesInOnePlace) {
  const FlatFace floor{{0, 0, 1}, {{1, 2, 0.25}, {5, 2, 0.25}, {5, 9, 0.25}, {1, 9, 0.25}}};
  const Standing start = at({0.7, -3, 5}, {0, 0, 90});
  const Landing landed = flush(start, {{0, 0, -1}, block_face(2, -1)}, floor, {true, false});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position, (Vec3{3, 5.5, 1.25}));
}

TEST(Placing, WhatDoublesCannotCentreIsSaidNotToBeExact) {
  // The middle lies between two doubles.
  const double high = std::nextafter(1.5, 2);
  const FlatFace floor{{0, 0, 1}, {{1, 1, 0}, {high, 1, 0}, {high, 4, 0}, {1, 4, 0}}};
  const Landing landed =
      flush(at({0.1, 0, 5}), {{0, 0, -1}, block_face(2, -1)}, floor, {true, false});
  EXPECT_FALSE(landed.is_exact);
  expect_near(landed.placement.position, {1.25, 2.5, 1});
}

TEST(Placing, SameSideIsLevel) {
  const Landing landed = flush(at({0, 0, 5}), {{0, 0, 1}, block_face(2, 1)},
                               {{0, 0, 1}, {{-5, -5, 3}, {5, -5, 3}, {5, 5, 3}}}, {false, true});
  EXPECT_TRUE(landed.is_exact);
  EXPECT_EQ(landed.placement.position, (Vec3{0, 0, 2}));
  EXPECT_EQ(landed.placement.rotation, Vec3());
}

TEST(Placing, SlantedFacesAreMetNearly) {
  const double half = std::sqrt(0.5);
  const FlatFace slope{{half, 0, half}, {{0, 0, 2}, {2, 0, 0}, {2, 4, 0}, {0, 4, 2}}};
  const Standing start = at({9, 9, 9});
  const Landing landed = flush(start, {{0, 0, -1}, block_face(2, -1)}, slope, {true, false});
  EXPECT_FALSE(landed.is_exact);
  const Standing there = start.with(landed.placement);
  for (const Vec3& corner : block_face(2, -1)) {
    const Vec3 p = there.image(corner);
    EXPECT_NEAR(p.x + p.z, 2, 1e-12);
  }
  expect_near(there.image({0, 0, -1}), {1, 2, 1});
}

TEST(Placing, EdgesLieOnEachOther) {
  const Standing start = at({5, 0, 0});
  // An edge along y goes onto one along x.
  const Landing landed =
      edge_on_edge(start, {{1, -1, 1}, {1, 1, 1}}, {{0.5, 3, 0.125}, {9, 3, 0.125}});
  EXPECT_TRUE(landed.is_exact);
  const Standing there = start.with(landed.placement);
  EXPECT_EQ(there.image({1, -1, 1}), (Vec3{0.5, 3, 0.125}));
  EXPECT_EQ(there.image({1, 1, 1}), (Vec3{2.5, 3, 0.125}));
}

TEST(Placing, BoxesAlign) {
  ExactBox box;
  const std::vector<Vec3> points{{-1, -1, -1}, {1, 1, 1}, {0, 3, 0}};
  box.add(at({0.1, 0, 0}), points);
  EXPECT_EQ(box.high[1]->value, 3);
  const Landing ground = aligned(box, 2, BoxPlace::low, 0);
  EXPECT_TRUE(ground.is_exact);
  EXPECT_EQ(ground.placement.position, (Vec3{0.1, 0, 1}));
  const Landing middle = centred(box, 1, 10, 20);
  EXPECT_TRUE(middle.is_exact);
  EXPECT_EQ(middle.placement.position, (Vec3{0.1, 14, 0}));
  EXPECT_EQ(aligned(box, 0, BoxPlace::high, 5).placement.position.x, 4);
}

TEST(Placing, InATurnedParentTheWorldCounts) {
  Standing standing = at({1, 2, 3});
  standing.parent = Transform::rotation_degrees({0, 0, 1}, 90);
  ExactBox box;
  box.add(standing, block_face(2, -1));
  const Landing landed = aligned(box, 0, BoxPlace::low, 7);
  EXPECT_TRUE(landed.is_exact);
  for (const Vec3& corner : block_face(2, -1))
    EXPECT_GE(standing.with(landed.placement).image(corner).x, 7);
  EXPECT_EQ(standing.with(landed.placement).image({1, 1, -1}).x, 7);
}

}  // namespace
}  // namespace sectile::viewer
