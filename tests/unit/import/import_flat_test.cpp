// Faces and corners without area: they go, and the surface stays closed.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;

// The cube's eight vertices, then the given ones.
std::vector<Vec3> cube_positions(std::initializer_list<Vec3> more) {
  std::vector<Vec3> positions = cube_mesh().positions;
  positions.insert(positions.end(), more);
  return positions;
}

void expect_cube(const std::vector<Vec3>& positions, const Faces& faces) {
  const Solid solid = Solid::from_mesh(with_faces(positions, faces));
  EXPECT_TRUE(validate(solid).empty());
  EXPECT_EQ(solid, block({0, 0, 0}, {1, 1, 1}));
}

// Bottom, top, low y, high x, high y, low x; some of them replaced, more appended.
Faces cube_faces(std::initializer_list<std::pair<std::size_t, std::vector<std::uint32_t>>> changed,
                 const Faces& more = {}) {
  Faces faces = faces_of(cube_mesh());
  for (const auto& [number, face] : changed) faces[number] = face;
  faces.insert(faces.end(), more.begin(), more.end());
  return faces;
}

TEST(ImportFlat, AFlatTriangleClosesATJunction) {
  // Only the top has a corner in the middle of the edge from 4 to 5.
  expect_cube(cube_positions({{0.5, 0, 1}}), cube_faces({{1, {4, 8, 5, 6, 7}}}, {{4, 5, 8}}));
}

TEST(ImportFlat, AChainOfFlatTrianglesOnOneLine) {
  expect_cube(cube_positions({{0.25, 0, 1}, {0.5, 0, 1}, {0.75, 0, 1}}),
              cube_faces({{1, {4, 8, 9, 10, 5, 6, 7}}}, {{4, 5, 9}, {4, 9, 8}, {9, 5, 10}}));
}

TEST(ImportFlat, FlatTrianglesWhoseCornersAreNoOthers) {
  // 8 and 9 are corners of flat faces only.
  expect_cube(cube_positions({{0.25, 0, 1}, {0.5, 0, 1}}),
              cube_faces({{1, {4, 8, 5, 6, 7}}}, {{4, 5, 9}, {4, 9, 8}, {8, 9, 5}}));
}

TEST(ImportFlat, TheCornerOfAFlatTriangleOutsideItsNeighbours) {
  // 8 lies beyond 5; the flat triangle's edges to it cancel those of a second one.
  expect_cube(cube_positions({{1.5, 0, 1}}), cube_faces({}, {{4, 5, 8}, {8, 5, 4}}));
}

TEST(ImportFlat, AFlatPolygonWithManyCorners) {
  expect_cube(cube_positions({{0.25, 0, 1}, {0.5, 0, 1}, {0.75, 0, 1}}),
              cube_faces({{1, {4, 8, 9, 10, 5, 6, 7}}}, {{4, 5, 10, 9, 8}}));
}

TEST(ImportFlat, RepeatedCornersAndPathsThereAndBackAgain) {
  expect_cube(cube_positions({{7, 7, 7}}), cube_faces({{1, {4, 4, 5, 5, 5, 6, 7, 4}},
                                                       {2, {0, 1, 5, 8, 5, 4}},
                                                       {3, {1, 2, 6, 5, 8, 7, 8, 5}}}));
}

TEST(ImportFlat, FacesOfOneOrTwoPlacesVanish) {
  expect_cube(cube_positions({}),
              cube_faces({}, {{0}, {0, 1}, {2, 2, 2}, {3, 3, 4}, {1, 2, 1, 2}, {}}));
}

TEST(ImportFlat, StraightCornersAreKeptOnBothSides) {
  const Solid solid = Solid::from_mesh(with_faces(
      cube_positions({{0.5, 0, 1}}), cube_faces({{1, {4, 8, 5, 6, 7}}, {2, {0, 1, 5, 8, 4}}})));
  EXPECT_EQ(solid.counts().vertices, 9u);
  EXPECT_EQ(solid, block({0, 0, 0}, {1, 1, 1}));
}

TEST(ImportFlat, ACornerOfZeroDegreesInTwoNeighbours) {
  // Both faces run from 4 on to 8, beyond 5, and turn back.
  expect_cube(cube_positions({{1.5, 0, 1}}),
              cube_faces({{1, {4, 8, 5, 6, 7}}, {2, {0, 1, 5, 8, 4}}}));
}

TEST(ImportFlat, FlatFacesOnlyAreNoSolid) {
  EXPECT_TRUE(
      Solid::from_mesh(with_faces({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {2, 1, 0}}))
          .is_empty());
}

TEST(ImportFlat, ASliverWithAreaStays) {
  // 8 lies one ulp inside the top: the flat-looking triangle has area.
  const double y = 0x1p-1074;
  const Solid solid = Solid::from_mesh(
      with_faces(cube_positions({{0.5, y, 1}}), cube_faces({{1, {4, 8, 5, 6, 7}}}, {{4, 5, 8}})));
  EXPECT_TRUE(validate(solid).empty());
  // It lies in the plane of the top, and is part of it.
  EXPECT_EQ(solid.counts().faces, 6u);
  EXPECT_EQ(solid.joined_faces(1), (std::vector<std::uint32_t>{1, 6}));
  EXPECT_EQ(solid, block({0, 0, 0}, {1, 1, 1}));
}

TEST(ImportFlat, AFaceThatTouchesItselfInACorner) {
  // The top of two prisms over triangles, drawn as one face whose loop visits a place twice.
  const std::vector<Vec3> low = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}};
  std::vector<Vec3> positions = low;
  for (const Vec3& p : low) positions.push_back({p.x, p.y, 1});
  const Solid solid = Solid::from_mesh(with_faces(positions, {{5, 6, 7, 8, 9, 7},
                                                              {2, 4, 3, 2, 1, 0},
                                                              {0, 1, 6, 5},
                                                              {1, 2, 7, 6},
                                                              {2, 0, 5, 7},
                                                              {2, 3, 8, 7},
                                                              {3, 4, 9, 8},
                                                              {4, 2, 7, 9}}));
  EXPECT_TRUE(validate(solid).empty());
  EXPECT_EQ(solid.volume(), 2);
  EXPECT_EQ(solid.counts().shells, 2u);
}

}  // namespace
}  // namespace sectile
