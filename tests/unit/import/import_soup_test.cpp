// The same solid, however its surface is written down.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "cases.h"
#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

using Random = std::mt19937;

std::set<Cell> random_cells(Random& random) {
  std::set<Cell> cells;
  const unsigned parts = 2 + random() % 4;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if (random() % parts > 0) cells.insert({x, y, z});
  return cells;
}

// Triangles in any order, cut along either diagonal, beginning anywhere; some vertices are shared.
PolygonMesh shuffled(const PolygonMesh& mesh, Random& random) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (const auto& square : faces_of(mesh)) {
    const unsigned start = random() % 4;
    const auto corner = [&](unsigned k) { return square[(start + k) % 4]; };
    if (random() % 3 == 0) {
      faces.push_back({corner(0), corner(1), corner(2), corner(3)});
    } else {
      faces.push_back({corner(0), corner(1), corner(2)});
      faces.push_back({corner(2), corner(3), corner(0)});
    }
  }
  std::shuffle(faces.begin(), faces.end(), random);
  std::vector<Vec3> positions = mesh.positions;
  std::vector<std::uint32_t> number(positions.size());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
  for (auto& face : faces)
    for (std::uint32_t& i : face)
      if (random() % 2) {
        const Vec3 copy = positions[i];
        i = static_cast<std::uint32_t>(positions.size());
        positions.push_back(copy);
      }
  number.resize(positions.size());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Vec3> permuted(positions.size());
  for (std::uint32_t i = 0; i < number.size(); ++i) permuted[number[i]] = positions[i];
  for (auto& face : faces)
    for (std::uint32_t& i : face) i = number[i];
  return with_faces(permuted, faces);
}

TEST(ImportSoup, ShuffledSoupsAreTheSameSolid) {
  Random random(2);
  for (int round = 0; round < cases(100); ++round) {
    const std::set<Cell> cells = random_cells(random);
    const PolygonMesh mesh = cell_mesh(cells);
    const Solid first = Solid::from_mesh(mesh), second = Solid::from_mesh(shuffled(mesh, random));
    ASSERT_TRUE(validate(second).empty()) << round;
    ASSERT_EQ(first.volume(), double(cells.size()));
    ASSERT_EQ(second.volume(), double(cells.size()));
    ASSERT_EQ(first, second) << round;
  }
}

TEST(ImportSoup, ThePartsOfASoupComeBackFromItsTriangles) {
  Random random(3);
  for (int round = 0; round < 30; ++round) {
    const Solid solid = Solid::from_mesh(cell_mesh(random_cells(random)));
    EXPECT_EQ(Solid::from_mesh(solid.to_mesh()), solid) << round;
  }
}

// All that can be seen of a solid's structure, in order.
void expect_same_bits(const Solid& a, const Solid& b) {
  std::vector<FaceSource> sources_a, sources_b;
  const PolygonMesh mesh_a = a.to_mesh(sources_a), mesh_b = b.to_mesh(sources_b);
  EXPECT_EQ(mesh_a.positions, mesh_b.positions);
  EXPECT_EQ(mesh_a.indices, mesh_b.indices);
  ASSERT_EQ(sources_a.size(), sources_b.size());
  for (std::size_t i = 0; i < sources_a.size(); ++i)
    ASSERT_EQ(sources_a[i].face, sources_b[i].face) << i;
}

TEST(ImportSoup, OneThreadAndTwoGiveTheSameBits) {
  Random random(4);
  const PolygonMesh sphere = sphere_mesh({0, 0, 0}, 1, cases(200u), cases(201u));
  PolygonMesh soup;
  for (std::uint32_t f = 0; f < sphere.face_sizes.size(); ++f) soup.face_sizes.push_back(3);
  for (const std::uint32_t i : sphere.indices) {
    soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
    soup.positions.push_back(sphere.positions[i]);
  }
  const PolygonMesh chequered = [] {
    std::set<Cell> cells;
    for (int x = 0; x < 12; ++x)
      for (int y = 0; y < 12; ++y)
        for (int z = 0; z < 12; ++z)
          if ((x + y + z) % 2) cells.insert({x, y, z});
    return cell_mesh(cells);
  }();
  for (const PolygonMesh& mesh : {sphere, soup, chequered}) {
    const auto import = [&](std::size_t threads) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      return Solid::from_mesh(mesh);
    };
    const Solid one = import(1);
    expect_same_bits(one, import(2));
    expect_same_bits(one, import(4));
  }
}

TEST(ImportSoup, AChessBoardOfCubesHasAVolume) {
  std::set<Cell> cells;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z)
        if ((x + y + z) % 2) cells.insert({x, y, z});
  const Solid solid = Solid::from_mesh(cell_mesh(cells));
  EXPECT_TRUE(validate(solid).empty());
  EXPECT_EQ(solid.volume(), 108);
  EXPECT_EQ(solid.counts().shells, 108u);
}

}  // namespace
}  // namespace sectile
