// Meshes that are solids: shared and own vertices, non-manifold places, bent faces, several shells.
#include <gtest/gtest.h>

#include <cmath>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

Solid legal(const PolygonMesh& mesh) {
  const Solid solid = Solid::from_mesh(mesh);
  for (const Violation& v : validate(solid)) ADD_FAILURE() << v.what;
  return solid;
}

void expect_counts(const Solid& solid, std::size_t vertices, std::size_t edges, std::size_t faces,
                   std::size_t shells) {
  const SolidCounts counts = solid.counts();
  EXPECT_EQ(counts.vertices, vertices);
  EXPECT_EQ(counts.edges, edges);
  EXPECT_EQ(counts.faces, faces);
  EXPECT_EQ(counts.shells, shells);
}

// Every corner has a position of its own.
PolygonMesh unshared(const PolygonMesh& mesh) {
  PolygonMesh own;
  own.face_sizes = mesh.face_sizes;
  for (const std::uint32_t i : mesh.indices) {
    own.indices.push_back(static_cast<std::uint32_t>(own.positions.size()));
    own.positions.push_back(mesh.positions[i]);
  }
  return own;
}

TEST(Import, NothingIsTheEmptySolid) {
  EXPECT_TRUE(Solid::from_mesh({}).is_empty());
  EXPECT_TRUE(Solid::from_mesh({{{1, 2, 3}}, {}, {}}).is_empty());
}

TEST(Import, SquaresOfACubeStayWhole) {
  const Solid cube = legal(cube_mesh());
  expect_counts(cube, 8, 12, 6, 1);
  EXPECT_EQ(cube.volume(), 1);
  EXPECT_EQ(cube.area(), 6);
}

TEST(Import, EqualPositionsAreOnePoint) {
  const Solid cube = legal(unshared(cube_mesh()));
  expect_counts(cube, 8, 12, 6, 1);
  EXPECT_EQ(cube, legal(cube_mesh()));
}

TEST(Import, MinusZeroIsZero) {
  PolygonMesh mesh = unshared(cube_mesh());
  for (std::size_t i = 0; i < mesh.positions.size(); i += 2)
    for (double* v : {&mesh.positions[i].x, &mesh.positions[i].y, &mesh.positions[i].z})
      if (*v == 0) *v = -0.0;
  EXPECT_EQ(legal(mesh), legal(cube_mesh()));
}

TEST(Import, UnusedPositionsDoNotMatter) {
  PolygonMesh mesh = cube_mesh();
  mesh.positions.push_back({5, 5, 5});
  expect_counts(legal(mesh), 8, 12, 6, 1);
}

TEST(Import, FacesKnowTheirNumber) {
  const Solid cube = legal(cube_mesh());
  std::vector<FaceSource> sources;
  const PolygonMesh triangles = cube.to_mesh(sources);
  ASSERT_EQ(sources.size(), 12u);
  std::size_t times[6] = {};
  for (const FaceSource& s : sources) {
    EXPECT_EQ(s.solid, cube.origin());
    ++times[s.face];
  }
  for (const std::size_t n : times) EXPECT_EQ(n, 2u);
}

TEST(Import, CubesThatShareAnEdgeAreTwoWedges) {
  const PolygonMesh mesh = cell_mesh({{0, 0, 0}, {1, 1, 0}});
  for (const PolygonMesh& m : {mesh, unshared(mesh)}) {
    const Solid solid = legal(m);
    expect_counts(solid, 16, 24, 12, 2);
    EXPECT_EQ(solid,
              boolean(block({0, 0, 0}, {1, 1, 1}), block({1, 1, 0}, {2, 2, 1}), Operation::unite));
  }
}

TEST(Import, CubesThatShareAVertexHaveTwoVerticesThere) {
  const Solid solid = legal(cell_mesh({{0, 0, 0}, {1, 1, 1}}));
  expect_counts(solid, 16, 24, 12, 2);
  EXPECT_EQ(solid.volume(), 2);
}

TEST(Import, CavitiesThatShareAnEdgeAreWedgesOfAir) {
  std::set<Cell> cells;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 3; ++z) cells.insert({x, y, z});
  cells.erase({1, 1, 1});
  cells.erase({2, 2, 1});
  const Solid solid = legal(cell_mesh(cells));
  EXPECT_EQ(solid.volume(), 46);
  // Material surrounds the common edge on two sides: the two cavities are joined there.
  EXPECT_EQ(solid.counts().shells, 2u);
  Solid expected = block({0, 0, 0}, {4, 4, 3});
  expected = boolean(expected, block({1, 1, 1}, {2, 2, 2}), Operation::subtract);
  expected = boolean(expected, block({2, 2, 1}, {3, 3, 2}), Operation::subtract);
  EXPECT_EQ(solid, expected);
}

TEST(Import, AllSubsetsOfTheCellsAroundAnEdge) {
  for (unsigned subset = 1; subset < 16; ++subset) {
    std::set<Cell> cells;
    for (int k = 0; k < 4; ++k)
      if (subset >> k & 1) cells.insert({k & 1, k >> 1, 0});
    const Solid solid = legal(unshared(cell_mesh(cells)));
    EXPECT_EQ(solid.volume(), double(cells.size())) << subset;
  }
}

TEST(Import, SixWedgesAroundALine) {
  // Three prisms that have nothing but the z axis in common.
  PolygonMesh mesh;
  const Vec3 rays[6] = {{4, 0, 0}, {4, 1, 0}, {-1, 4, 0}, {-2, 4, 0}, {-2, -3, 0}, {-1, -3, 0}};
  for (int k = 0; k < 6; k += 2) {
    std::vector<Vec3> p = {{0, 0, 0}, rays[k], rays[k + 1]};
    for (int i = 0; i < 3; ++i) p.push_back({p[i].x, p[i].y, 1});
    mesh = joined(mesh,
                  with_faces(p, {{2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}));
  }
  const Solid solid = legal(mesh);
  expect_counts(solid, 18, 27, 15, 3);
}

TEST(Import, BentFacesAreTriangulated) {
  PolygonMesh mesh = cube_mesh();
  mesh.positions[6].z = 1.5;
  const Solid solid = legal(mesh);
  EXPECT_EQ(solid.counts().vertices, 8u);
  EXPECT_EQ(solid.counts().faces, 7u);  // the sides stay plane, the top becomes two triangles
  mesh.positions[6] = {1.25, 1.125, 1.5};
  EXPECT_EQ(legal(mesh).counts().faces, 9u);
}

TEST(Import, BentPolygonsWithManyCorners) {
  // The wall and the lid of a drum whose rim goes up and down.
  constexpr std::uint32_t n = 30;
  std::vector<Vec3> positions;
  std::vector<std::vector<std::uint32_t>> faces(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    positions.push_back({std::cos(angle), std::sin(angle), 0});
    positions.push_back({std::cos(angle), std::sin(angle), i % 2 ? 1.0 : 1.25});
    const std::uint32_t next = (i + 1) % n;
    faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    faces[0].insert(faces[0].begin(), 2 * i);
    faces[1].push_back(2 * i + 1);
  }
  const Solid solid = legal(with_faces(positions, faces));
  EXPECT_EQ(solid.counts().vertices, 60u);
  EXPECT_GT(solid.volume(), 3.1);
}

TEST(Import, APrismOverAPolygonWith300Corners) {
  constexpr std::uint32_t n = 300;
  std::vector<Vec3> positions;
  std::vector<std::vector<std::uint32_t>> faces(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    // A star: every other corner is reflex.
    const double angle = 2 * M_PI * i / n, radius = i % 2 ? 1 : 2;
    positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 3});
    const std::uint32_t next = (i + 1) % n;
    faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    faces[0].insert(faces[0].begin(), 2 * i);
    faces[1].push_back(2 * i + 1);
  }
  const Solid solid = legal(with_faces(positions, faces));
  expect_counts(solid, 600, 900, 302, 1);
  EXPECT_NEAR(solid.volume(), 3 * n * std::sin(2 * M_PI / n), 1e-12);
}

TEST(Import, ANonConvexFaceKeepsItsPlane) {
  // The first corner of the L is reflex.
  const std::vector<Vec3> low = {{1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}};
  std::vector<Vec3> positions = low;
  for (const Vec3& p : low) positions.push_back({p.x, p.y, 1});
  std::vector<std::vector<std::uint32_t>> faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::uint32_t i = 0; i < 6; ++i) faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  const Solid solid = legal(with_faces(positions, faces));
  expect_counts(solid, 12, 18, 8, 1);
  EXPECT_EQ(solid.volume(), 3);
}

TEST(Import, CavitiesAndIslandsWithinThem) {
  PolygonMesh mesh = joined(cube_mesh({0, 0, 0}, 9), turned_over(cube_mesh({1, 1, 1}, 7)));
  EXPECT_EQ(legal(mesh).volume(), 729 - 343);
  mesh = joined(mesh, cube_mesh({2, 2, 2}, 5));
  EXPECT_EQ(legal(mesh).volume(), 729 - 343 + 125);
  mesh = joined(mesh, turned_over(cube_mesh({3, 3, 3}, 1)));
  const Solid solid = legal(mesh);
  EXPECT_EQ(solid.volume(), 729 - 343 + 125 - 1);
  EXPECT_EQ(solid.counts().shells, 4u);
}

TEST(Import, ACavityMayTouchItsShellInAVertex) {
  // The apex of the hollow pyramid lies in the middle of the cube's top.
  const PolygonMesh pyramid =
      with_faces({{1, 1, 1}, {3, 1, 1}, {3, 3, 1}, {1, 3, 1}, {2, 2, 4}},
                 {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const Solid solid = legal(joined(cube_mesh({0, 0, 0}, 4), turned_over(pyramid)));
  EXPECT_EQ(solid.volume(), 60);
}

TEST(Import, FarExponentsStayExact) {
  const double tiny = 0x1p-1000;
  PolygonMesh mesh = cube_mesh();
  mesh.positions[6] = {1 + 0x1p-52, 1, 1 + tiny};  // 1 + tiny is 1
  mesh.positions[0] = {tiny, -tiny, tiny};
  const Solid solid = legal(mesh);
  EXPECT_EQ(solid.counts().vertices, 8u);
  EXPECT_GT(solid.counts().faces, 6u);
}

}  // namespace
}  // namespace sectile
