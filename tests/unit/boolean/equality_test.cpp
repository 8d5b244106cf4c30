// Solids are equal if they are the same set of points, however they came about.
#include <gtest/gtest.h>

#include <algorithm>

#include "boolean/boolean.h"
#include "boolean/same_faces.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

Solid ball(const Vec3& centre, std::uint32_t segments = 40) {
  return Solid::from_mesh(sphere_mesh(centre, 1, segments, segments / 2));
}

bool same_faces(const Solid& a, const Solid& b) {
  return have_same_faces(*a.data(), *b.data());
}

TEST(Equality, OfOneMeshReadTwice) {
  const PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, 60, 30);
  PolygonMesh backwards = mesh;  // faces last first, each from another corner
  std::reverse(backwards.indices.begin(), backwards.indices.end());
  for (std::size_t i = 0; i < backwards.indices.size(); i += 3)
    std::swap(backwards.indices[i], backwards.indices[i + 1]);
  const Solid a = Solid::from_mesh(mesh), b = Solid::from_mesh(backwards);
  EXPECT_TRUE(same_faces(a, b));
  EXPECT_EQ(a, b);
}

TEST(Equality, OfOneResultComputedTwice) {
  const Solid a = boolean(ball({0, 0, 0}), ball({0.7, 0.1, 0.2}), Operation::unite);
  const Solid b = boolean(ball({0.7, 0.1, 0.2}), ball({0, 0, 0}), Operation::unite);
  EXPECT_TRUE(same_faces(a, b));
  EXPECT_EQ(a, b);
}

// Nothing is cut: what stays is the first one, as it is.
TEST(Equality, OfOperands) {
  const Solid a = boolean(ball({0, 0, 0}), ball({0.7, 0.1, 0.2}), Operation::unite);
  const Solid b = boolean(ball({0.7, 0.1, 0.2}), ball({0, 0, 0}), Operation::unite);
  for (const Solid* other : {&a, &b}) {
    EXPECT_EQ(boolean(a, *other, Operation::unite).data(), a.data());
    EXPECT_EQ(boolean(a, *other, Operation::intersect).data(), a.data());
    EXPECT_TRUE(boolean(a, *other, Operation::subtract).is_empty());
  }
}

TEST(Equality, OfOperandsAsCuttingHasIt) {
  const Solid a = boolean(ball({0, 0, 0}), ball({0.7, 0.1, 0.2}), Operation::unite);
  const Solid b = boolean(ball({0.7, 0.1, 0.2}), ball({0, 0, 0}), Operation::unite);
  for (const Solid* other : {&a, &b}) {
    EXPECT_TRUE(same_faces(boolean_by_cutting(a, *other, Operation::unite, {}), a));
    EXPECT_TRUE(same_faces(boolean_by_cutting(a, *other, Operation::intersect, {}), a));
    EXPECT_TRUE(boolean_by_cutting(a, *other, Operation::subtract, {}).is_empty());
  }
}

TEST(Equality, OfTheComplementOfTheComplement) {
  const Solid a = ball({0, 0, 0}), around = block({-2, -2, -2}, {2, 2, 2});
  const Solid hollow = boolean(around, a, Operation::subtract);
  EXPECT_EQ(boolean(around, hollow, Operation::subtract), a);
  EXPECT_FALSE(same_faces(hollow, a));
}

TEST(Equality, WhereFacesAreDividedInDifferentWays) {
  const Solid whole = block({0, 0, 0}, {2, 1, 1});
  PolygonMesh divided = whole.to_mesh();
  const Solid halves =
      boolean(block({0, 0, 0}, {1, 1, 1}), block({1, 0, 0}, {2, 1, 1}), Operation::unite);
  EXPECT_EQ(halves, whole);
  EXPECT_EQ(Solid::from_mesh(divided), halves);
}

// A block whose edge along x has corners at these places.
Solid block_with_corners(const std::vector<double>& places) {
  PolygonMesh mesh{
      {{0, 0, 0}, {0, 3, 0}, {3, 3, 0}, {3, 0, 0}, {0, 0, 1}, {0, 3, 1}, {3, 3, 1}, {3, 0, 1}},
      {4, 4, 4, 4},
      {4, 7, 6, 5, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3}};
  const auto add_face = [&](std::vector<std::uint32_t> corners) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
  };
  std::vector<std::uint32_t> bottom{0, 1, 2, 3}, front{7, 4, 0, 3};
  for (const double x : places) {
    const auto corner = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({x, 0, 0});
    front.insert(front.end() - 1, corner);
    bottom.insert(bottom.begin() + 4, corner);
  }
  add_face(bottom);
  add_face(front);
  return Solid::from_mesh(mesh);
}

TEST(Equality, WhereEdgesAreDividedInDifferentWays) {
  const Solid divided = block_with_corners({1}), otherwise = block_with_corners({0.5, 2});
  const Solid whole = block_with_corners({});
  EXPECT_NE(divided.counts().vertices, otherwise.counts().vertices);
  for (const Solid* solid : {&divided, &otherwise, &whole}) {
    EXPECT_TRUE(same_faces(*solid, whole));
    EXPECT_TRUE(same_faces(whole, *solid));
    EXPECT_TRUE(same_faces(*solid, divided));
  }
}

TEST(Equality, OfImages) {
  const Transform turn = Transform::rotation_degrees({1, 2, 3}, 40);
  const Solid a = ball({0, 0, 0}), b = ball({0.7, 0.1, 0.2});
  const Solid first = transformed(boolean(a, b, Operation::subtract), turn);
  const Solid second = boolean(transformed(a, turn), transformed(b, turn), Operation::subtract);
  EXPECT_EQ(first, second);
}

// Of one volume and area.
TEST(Equality, NotOfMovedOrMirroredSolids) {
  const Solid a = boolean(ball({0, 0, 0}), block({0.1, 0.2, 0.3}, {2, 2, 2}), Operation::subtract);
  for (const Transform& move : {Transform::translation({0, 0, 1e-9}),
                                Transform::scaling({-1, 1, 1}), Transform::scaling({1, -1, 1})}) {
    EXPECT_FALSE(a == transformed(a, move));
    EXPECT_FALSE(transformed(a, move) == a);
  }
}

TEST(Equality, NotWhereTheLeastOfDoublesIsMissing) {
  const Solid a = block({0, 0, 0}, {1, 1, 1});
  const Solid b =
      boolean(a, block({0, 0, 0}, {0x1p-1074, 0x1p-1074, 0x1p-1074}), Operation::subtract);
  EXPECT_EQ(a.volume(), b.volume());
  EXPECT_FALSE(a == b);
}

TEST(Equality, NotWhereMaterialAndVoidChangePlaces) {
  // Of two cubes within each other, the inner one full or hollow.
  const Solid outer = block({0, 0, 0}, {4, 4, 4}), inner = block({1, 1, 1}, {2, 2, 2});
  EXPECT_FALSE(boolean(outer, inner, Operation::subtract) == outer);
  EXPECT_FALSE(outer == inner);
}

TEST(Equality, OfAHundredThousandTrianglesButAFew) {
  const Solid whole = ball({0, 0, 0}, 320);
  const Solid cut = boolean(whole, block({0.9, -0.1, -0.1}, {2, 0.1, 0.1}), Operation::subtract);
  const Solid filled =
      boolean(cut, boolean(whole, block({0.8, -0.2, -0.2}, {2, 0.2, 0.2}), Operation::intersect),
              Operation::unite);
  EXPECT_FALSE(cut == whole);
  EXPECT_TRUE(cut == boolean(whole, block({0.9, -0.1, -0.1}, {2, 0.1, 0.1}), Operation::subtract));
  EXPECT_TRUE(same_faces(filled, whole));
  EXPECT_EQ(filled, whole);
}

}  // namespace
}  // namespace sectile
