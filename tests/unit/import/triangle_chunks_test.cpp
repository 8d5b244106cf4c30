// A mesh of triangles is the same surface, or none, however it is cut into chunks.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "import/triangles/read_chunks.h"

namespace sectile {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::vector<Vec3> places = {{0, 0, 3},  {3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0},
                                  {0, 0, -3}, {5, 6, 7}, {7, 5, 9}, {6, 9, 4},  {9, 8, 8}};

// Around the points 0 to 5.
const Triangles octahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                              {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};

Triangles tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
}

Triangles together(Triangles some, const Triangles& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

// Calls visit(mesh, shells) for all ways to cut the triangles, in their order, into chunks.
template <class Visit>
void for_each_cut(const Triangles& triangles, const Visit& visit) {
  std::vector<std::uint32_t> corners;
  for (const auto& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
  for (std::uint32_t cuts = 0; cuts < 1u << (triangles.size() - 1); ++cuts) {
    SCOPED_TRACE(cuts);
    TriangleMesh mesh;
    mesh.positions = places;
    mesh.input_corners = corners;
    mesh.chunk_begins = {0};
    std::uint32_t most = 0;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      mesh.source.push_back(t);
      if (t > 0 && (cuts >> (t - 1) & 1u) != 0) mesh.chunk_begins.push_back(t);
      most = std::max(most, t + 1 - mesh.chunk_begins.back());
    }
    if (most > TriangleMesh::most_of_a_chunk) continue;
    mesh.chunk_begins.push_back(static_cast<std::uint32_t>(triangles.size()));
    ChunkReaders readers;
    const auto shells = read_surface(readers, mesh);
    visit(mesh, shells);
  }
}

void expect_refused(const Triangles& triangles) {
  for_each_cut(triangles, [](const TriangleMesh&, const auto& shells) { EXPECT_FALSE(shells); });
}

TEST(TriangleChunks, KnowTheMatesOfAllCorners) {
  for_each_cut(octahedron, [](TriangleMesh& mesh, const auto& shells) {
    ASSERT_TRUE(shells);
    EXPECT_EQ(shells->count, 1u);
    find_mates(mesh);
    for (std::uint32_t corner = 0; corner < 24; ++corner) {
      EXPECT_EQ(mesh.mate[mesh.mate[corner]], corner);
      EXPECT_EQ(mesh.from(mesh.mate[corner]), mesh.to(corner));
      EXPECT_EQ(mesh.to(mesh.mate[corner]), mesh.from(corner));
    }
  });
}

TEST(TriangleChunks, EncloseTheSameVolume) {
  for_each_cut(octahedron, [](const TriangleMesh& mesh, const auto&) {
    VolumeSum sum;
    for (const TriangleChunk& chunk : mesh.chunks) sum = sum + chunk.volume;
    EXPECT_EQ(sum.value(), 6 * 36);
  });
}

TEST(TriangleChunks, KnowTheirShells) {
  for_each_cut(together(tetrahedron(0, 1, 2, 3), tetrahedron(6, 7, 8, 9)),
               [](const TriangleMesh&, const auto& shells) {
                 ASSERT_TRUE(shells);
                 EXPECT_EQ(shells->count, 2u);
                 EXPECT_EQ(shells->of, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
               });
}

// The sides of a square pyramid are in planes of their own; those of its base are in one.
TEST(TriangleChunks, KnowWhichTrianglesAreInOnePlaneWithNeighbours) {
  const Triangles pyramid = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}};
  for_each_cut(pyramid, [](const TriangleMesh& mesh, const auto& shells) {
    ASSERT_TRUE(shells);
    std::vector<std::uint32_t> flat = mesh.borders.flat;
    for (std::uint32_t c = 0; c < mesh.chunk_count(); ++c)
      for (const std::uint32_t t : mesh.chunks[c].flat) flat.push_back(mesh.chunk_begin(c) + t);
    std::sort(flat.begin(), flat.end());
    EXPECT_EQ(flat, (std::vector<std::uint32_t>{4, 5}));
  });
}

TEST(TriangleChunks, AreNoSurfaceIfTwoShellsShareAPoint) {
  expect_refused(together(tetrahedron(0, 1, 2, 3), tetrahedron(0, 6, 7, 8)));
}

TEST(TriangleChunks, AreNoSurfaceIfTwoShellsShareAnEdge) {
  expect_refused(together(tetrahedron(0, 1, 2, 3), tetrahedron(0, 1, 7, 8)));
  expect_refused(together(tetrahedron(0, 1, 2, 3), tetrahedron(1, 0, 7, 8)));
}

TEST(TriangleChunks, AreNoSurfaceIfATriangleIsMissing) {
  for (std::size_t t = 0; t < octahedron.size(); ++t) {
    Triangles open = octahedron;
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(t));
    expect_refused(open);
  }
}

TEST(TriangleChunks, AreNoSurfaceIfATriangleIsTurned) {
  for (std::size_t t = 0; t < octahedron.size(); ++t) {
    Triangles turned = octahedron;
    std::swap(turned[t][0], turned[t][1]);
    expect_refused(turned);
  }
}

TEST(TriangleChunks, AreNoSurfaceIfATriangleIsThereTwice) {
  Triangles doubled = octahedron;
  doubled.push_back(octahedron[2]);
  expect_refused(doubled);
}

TEST(TriangleChunks, AreRefusedIfATriangleHasNoArea) {
  Triangles pinched = octahedron;
  pinched[3] = {0, 4, 4};
  expect_refused(pinched);
}

}  // namespace
}  // namespace sectile
