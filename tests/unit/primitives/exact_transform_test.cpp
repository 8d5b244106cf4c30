#include "sectile/exact_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/validate.h"

namespace sectile {
namespace {

ExactTransform move(double x) {
  return Transform::translation({x, 0, 0});
}

Vec3 difference(const ExactTransform& a, const Vec3& p, const ExactTransform& b, const Vec3& q) {
  const WeightedImage images[] = {{a, p, 1}, {b, q, -1}};
  return sum_of_images(images);
}

TEST(ExactTransform, KeepsWhatASumOfDoublesLoses) {
  const ExactTransform both = move(0x1p-60) * move(1);
  EXPECT_EQ(both.nearest().m[3], 1);
  EXPECT_EQ(difference(both, {0, 0, 0}, move(1), {0, 0, 0}), (Vec3{0x1p-60, 0, 0}));
  EXPECT_EQ(move(-0x1p-60) * both, move(1));
  EXPECT_EQ(both * move(-1), move(0x1p-60));
}

TEST(ExactTransform, MovesThatCancelAreTheIdentity) {
  const ExactTransform there = move(0.1) * move(1e17);
  const auto back = there.inverse();
  ASSERT_TRUE(back);
  EXPECT_TRUE((*back * there).is_identity());
  const Solid cube = block({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(transformed(transformed(cube, there), *back), cube);
}

TEST(ExactTransform, InvertsWhatDoublesCanInvertAndNothingElse) {
  const ExactTransform turned = ExactTransform(Transform::translation({0.1, 0.2, 0.3})) *
                                Transform::rotation_degrees({0, 0, 1}, 90) *
                                Transform::scaling({2, -0.25, 1});
  ASSERT_TRUE(turned.inverse());
  EXPECT_TRUE((*turned.inverse() * turned).is_identity());
  EXPECT_TRUE((turned * *turned.inverse()).is_identity());
  EXPECT_FALSE(ExactTransform(Transform::scaling({3, 1, 1})).inverse());
  EXPECT_FALSE(ExactTransform(Transform::rotation_degrees({0, 0, 1}, 30)).inverse());
  EXPECT_FALSE(ExactTransform(Transform::scaling({0, 1, 1})).inverse());
}

TEST(ExactTransform, RefusesWhatIsNotFiniteAndFlatImages) {
  EXPECT_THROW(ExactTransform(Transform::translation({INFINITY, 0, 0})), std::invalid_argument);
  EXPECT_THROW(
      transformed(block({0, 0, 0}, {1, 1, 1}), ExactTransform(Transform::scaling({1, 0, 1}))),
      std::invalid_argument);
}

TEST(ExactTransform, ASumOfImagesIsZeroOnlyIfItIsZero) {
  const ExactTransform none;
  const WeightedImage equal[] = {
      {none, {0.1, 0.2, 1e300}, 1}, {none, {0.2, 0.4, 1e300}, -0.5}, {none, {0, 0, 1e300}, -0.5}};
  EXPECT_EQ(sum_of_images(equal), (Vec3{0, 0, 0}));
  const WeightedImage tiny[] = {{none, {0x1p-1074, 0, 0}, 0x1p-60}};
  EXPECT_NE(sum_of_images(tiny).x, 0);
}

// A block's side at 0.1 + 0.2 is no double: only the exact sum brings another block to it.
TEST(ExactTransform, SolidsMovedByExactSumsAreFlush) {
  const Solid wall = transformed(block({-0.2, -1, -1}, {0.2, 1, 1}), move(0.1));
  const Solid cube = block({-0.05, -0.5, -0.5}, {0.05, 0.5, 0.5});
  const ExactTransform onto = move(0.05) * move(0.2) * move(0.1);
  const Solid flush = transformed(cube, onto);
  EXPECT_TRUE(boolean(flush, wall, Operation::intersect).is_empty());
  EXPECT_EQ(boolean(flush, wall, Operation::unite).counts().shells, 1u);
  const Solid near = transformed(cube, Transform::translation({0.05 + (0.2 + 0.1), 0, 0}));
  EXPECT_NE(boolean(near, wall, Operation::unite).counts().faces,
            boolean(flush, wall, Operation::unite).counts().faces)
      << "the doubles alone miss it";
  EXPECT_EQ(flush.counts().faces, cube.counts().faces);
}

TEST(ExactMesh, TellsWhichCornersAreDoublesAndWhatOthersLack) {
  const ExactTransform place = move(0.2) * move(0.1);
  const ExactMesh moved = exact_mesh(transformed(block({0, 0, 0}, {1, 1, 1}), place));
  const PolygonMesh mesh = transformed(block({0, 0, 0}, {1, 1, 1}), place).to_mesh();
  EXPECT_EQ(Solid::from_mesh(moved.mesh), Solid::from_mesh(mesh));
  ASSERT_EQ(moved.corners.size(), mesh.positions.size());
  for (std::size_t i = 0; i < moved.corners.size(); ++i)
    EXPECT_EQ(moved.corners[i].near, moved.mesh.positions[i]);
  for (const ExactCorner& corner : moved.corners) {
    EXPECT_EQ(corner.is_exact, (std::array<bool, 3>{true, true, true}));
    const ExactTransform none;
    const double x = corner.near.x > 1 ? 1 : 0;
    const WeightedImage images[] = {{none, corner.near, 1},
                                    {none, corner.rest, 1},
                                    {place, {x, corner.near.y, corner.near.z}, -1}};
    EXPECT_EQ(sum_of_images(images), (Vec3{0, 0, 0}));
    EXPECT_NE(corner.rest.x, 0);
  }
}

TEST(ExactMesh, AThirdIsNoSumOfDoubles) {
  const Solid cut = split(block({0, 0, 0}, {1, 1, 1}), {3, 1, 0, -1}).first;
  int thirds = 0;
  for (const ExactCorner& corner : exact_mesh(cut).corners) {
    EXPECT_TRUE(corner.is_exact[1] && corner.is_exact[2]);
    if (corner.near.x != 1.0 / 3) continue;
    ++thirds;
    EXPECT_FALSE(corner.is_exact[0]);
    EXPECT_NEAR(corner.rest.x, 0x1p-54 / 3, 0x1p-100);
  }
  EXPECT_EQ(thirds, 2);
}

}  // namespace
}  // namespace sectile
