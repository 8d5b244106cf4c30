// Coplanar neighbours become one face on import.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

Solid legal(const Solid& solid) {
  for (const Violation& v : validate(solid)) ADD_FAILURE() << v.what;
  return solid;
}

// Each face stays as it is.
Solid apart(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> each(mesh.face_sizes.size());
  std::iota(each.begin(), each.end(), 0u);
  ImportOptions options;
  options.face_groups = each;
  return Solid::from_mesh(mesh, options);
}

// Two triangles for each square.
PolygonMesh triangles_of(const std::set<Cell>& cells) {
  return apart(cell_mesh(cells)).to_mesh();
}

std::set<Cell> box_of_cells(const Cell& size) {
  std::set<Cell> cells;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) cells.insert({x, y, z});
  return cells;
}

using Corners = std::array<std::array<double, 3>, 3>;

// The triangles as sets of places that are read round from the first, with what `name` says.
template <class Name>
std::multiset<std::pair<Corners, std::uint32_t>> triangles_in(const PolygonMesh& mesh,
                                                              const Name& name) {
  std::multiset<std::pair<Corners, std::uint32_t>> found;
  for (std::uint32_t t = 0; t < mesh.face_sizes.size(); ++t) {
    EXPECT_EQ(mesh.face_sizes[t], 3u);
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.indices[3 * t + k]];
      corners[k] = {p.x, p.y, p.z};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    found.insert({corners, name(t)});
  }
  return found;
}

void expect_counts(const Solid& solid, std::size_t vertices, std::size_t edges, std::size_t faces,
                   std::size_t loops) {
  const SolidCounts counts = solid.counts();
  EXPECT_EQ(counts.vertices, vertices);
  EXPECT_EQ(counts.edges, edges);
  EXPECT_EQ(counts.faces, faces);
  EXPECT_EQ(counts.loops, loops);
}

TEST(ImportJoin, ABlockOfCellsHasSixFaces) {
  const Solid solid = legal(Solid::from_mesh(triangles_of(box_of_cells({4, 3, 5}))));
  expect_counts(solid, 8, 12, 6, 6);
  EXPECT_EQ(solid.volume(), 60);
  EXPECT_EQ(solid.area(), 94);
  EXPECT_EQ(solid, block({0, 0, 0}, {4, 3, 5}));
}

TEST(ImportJoin, AFrameHasFacesWithHoles) {
  std::set<Cell> cells = box_of_cells({3, 3, 1});
  cells.erase({1, 1, 0});
  const Solid frame = legal(Solid::from_mesh(triangles_of(cells)));
  expect_counts(frame, 16, 24, 10, 12);
  EXPECT_EQ(frame.counts().genus, 1);
  EXPECT_EQ(frame.volume(), 8);
}

TEST(ImportJoin, StepsKeepTheirEdges) {
  const Solid steps =
      legal(Solid::from_mesh(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {2, 0, 0}})));
  expect_counts(steps, 12, 18, 8, 8);
}

TEST(ImportJoin, FacesAtAPlaceWhereTheBoundaryTouchesItselfStay) {
  // Two columns that touch each other in an edge, on one plate.
  std::set<Cell> cells = box_of_cells({4, 4, 1});
  for (const Cell& c : {Cell{1, 1, 1}, Cell{2, 2, 1}}) cells.insert(c);
  const PolygonMesh mesh = triangles_of(cells);
  const Solid solid = legal(Solid::from_mesh(mesh));
  EXPECT_LT(solid.counts().faces, mesh.face_sizes.size() / 2);
  EXPECT_EQ(solid.volume(), 18);
  EXPECT_EQ(solid, apart(mesh));
}

TEST(ImportJoin, AHoleThatTouchesTheOuterLoopInACorner) {
  std::set<Cell> cells = box_of_cells({4, 4, 2});
  for (const Cell& c : {Cell{0, 0, 1}, Cell{1, 1, 1}}) cells.erase(c);
  const PolygonMesh mesh = triangles_of(cells);
  EXPECT_EQ(legal(Solid::from_mesh(mesh)), apart(mesh));
}

TEST(ImportJoin, GroupsStayApart) {
  const PolygonMesh mesh = triangles_of(box_of_cells({2, 1, 1}));
  std::vector<std::uint32_t> group(mesh.face_sizes.size());
  for (std::size_t f = 0; f < group.size(); ++f) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += mesh.positions[mesh.indices[3 * f + k]].x;
    group[f] = x > 3;
  }
  ImportOptions options;
  options.face_groups = group;
  const Solid solid = legal(Solid::from_mesh(mesh, options));
  expect_counts(solid, 12, 20, 10, 10);
  group.pop_back();
  options.face_groups = group;
  EXPECT_THROW(Solid::from_mesh(mesh, options), InvalidSolid);
}

TEST(ImportJoin, TheMeshIsGivenBack) {
  std::set<Cell> cells = box_of_cells({3, 3, 2});
  cells.erase({1, 1, 1});
  const PolygonMesh mesh = triangles_of(cells);
  const Solid solid = Solid::from_mesh(mesh);
  std::vector<FaceSource> sources;
  const PolygonMesh back = solid.to_mesh(sources);
  const auto itself = [](std::uint32_t t) { return t; };
  const auto source = [&](std::uint32_t t) { return sources[t].face; };
  EXPECT_EQ(triangles_in(back, source), triangles_in(mesh, itself));
  EXPECT_EQ(back.positions.size(), mesh.positions.size());
  for (const FaceSource& s : sources) EXPECT_EQ(s.solid, solid.origin());

  for (const Vec3& by : {Vec3{2, 4, 1}, Vec3{-2, 4, 1}}) {
    const Transform stretch = Transform::scaling(by);
    EXPECT_EQ(triangles_in(transformed(solid, stretch).to_mesh(sources), source),
              triangles_in(transformed(mesh, stretch), itself));
  }
}

// A cube whose top is halved: its front and back have a corner more, which goes with the halves.
TEST(ImportJoin, TheMeshGivenBackIsClosedWhereANeighbourHasLostACorner) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                    {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 2}, {1, 2, 2}};
  mesh.face_sizes = {4, 4, 4, 5, 5, 4, 4};
  mesh.indices = {0, 3, 2, 1, 4, 8, 9, 7, 8, 5, 6, 9, 0, 1, 5,
                  8, 4, 2, 3, 7, 9, 6, 1, 2, 6, 5, 3, 0, 4, 7};
  const Solid solid = legal(Solid::from_mesh(mesh));
  EXPECT_EQ(solid.counts().faces, 6u);
  EXPECT_EQ(solid.counts().vertices, 8u);
  const PolygonMesh back = solid.to_mesh();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < back.indices.size(); ++i)
    ++edges[{back.indices[i], back.indices[i % 3 == 2 ? i - 2 : i + 1]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(ImportJoin, TheFirstFaceNamesTheOthers) {
  const PolygonMesh mesh = triangles_of(box_of_cells({2, 2, 2}));
  const Solid cube = Solid::from_mesh(mesh);
  const Solid half = split(cube, {1, 0.5, 0, -1}).first;
  std::vector<FaceSource> sources;
  half.to_mesh(sources);
  std::set<std::uint32_t> names, all;
  for (const FaceSource& s : sources)
    if (s.solid == cube.origin()) names.insert(s.face);
  EXPECT_EQ(names.size(), 5u);
  for (const std::uint32_t name : names) {
    const std::vector<std::uint32_t> faces = cube.joined_faces(name);
    EXPECT_EQ(faces.size(), 8u);
    EXPECT_EQ(faces.front(), name);
    all.insert(faces.begin(), faces.end());
  }
  EXPECT_EQ(all.size(), 40u);
  EXPECT_EQ(block({0, 0, 0}, {1, 1, 1}).joined_faces(3), std::vector<std::uint32_t>{3});
}

TEST(ImportJoin, ResultsAreThoseOfTheTriangles) {
  std::mt19937 random(7);
  const auto cells = [&] {
    std::set<Cell> some;
    for (const Cell& c : box_of_cells({4, 4, 3}))
      if (random() % 5 > 1) some.insert(c);
    return some;
  };
  for (int round = 0; round < 4; ++round) {
    const PolygonMesh mesh_a = triangles_of(cells()), mesh_b = triangles_of(cells());
    const Solid a = Solid::from_mesh(mesh_a), b = Solid::from_mesh(mesh_b);
    const Solid a_apart = apart(mesh_a), b_apart = apart(mesh_b);
    ASSERT_EQ(a, a_apart);
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      const Solid result = legal(boolean(a, b, operation));
      const Solid expected = boolean(a_apart, b_apart, operation);
      EXPECT_EQ(result.volume(), expected.volume());
      EXPECT_EQ(result, expected);
    }
  }
}

}  // namespace
}  // namespace sectile
