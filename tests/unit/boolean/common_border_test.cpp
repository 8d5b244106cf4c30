// Boundaries with vertices in the same places: most of their faces have a corner or an edge in
// common, and nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sectile/sectile.h"
#include "terrain.h"
#include "volumes.h"

namespace sectile {
namespace {

// With heights that are small integers.
class Terrain {
 public:
  Terrain(std::uint32_t cells, int highest, std::uint32_t seed) : cells_(cells) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> height(1, highest);
    for (std::uint32_t i = 0; i < (cells + 1) * (cells + 1); ++i) height_.push_back(height(random));
  }

  Solid solid(bool rising) const {
    const bench::Terrain terrain{cells_,
                                 [&](std::uint32_t i, std::uint32_t j) { return height(i, j); }};
    return Solid::from_mesh(bench::terrain_mesh(terrain, rising));
  }

  /// What is below both ways to halve the cells. In a cell the two are as far from each other in
  /// its centre as nowhere else, and one at its sides.
  double common_volume() const {
    double volume = 0;
    for (std::uint32_t i = 0; i < cells_; ++i)
      for (std::uint32_t j = 0; j < cells_; ++j) {
        const double rising = height(i, j) + height(i + 1, j + 1),
                     falling = height(i + 1, j) + height(i, j + 1);
        // Halved either way, both diagonals weigh alike but for a pyramid over the cell.
        volume += (rising + falling) / 4 - std::abs(rising - falling) / 2 / 6;
      }
    return volume;
  }

 private:
  double height(std::uint32_t i, std::uint32_t j) const { return height_[i * (cells_ + 1) + j]; }

  std::uint32_t cells_;
  std::vector<int> height_;
};

void expect_common_volume(const Terrain& terrain) {
  test::expect_volumes(terrain.solid(true), terrain.solid(false), terrain.common_volume(), 1e-9);
}

TEST(CommonBorder, OfTwoWaysToHalveTheCellsOfATerrain) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) expect_common_volume(Terrain(7, 20, seed));
}

TEST(CommonBorder, OfTerrainsManyCellsOfWhichAreFlat) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) expect_common_volume(Terrain(7, 2, seed));
}

TEST(CommonBorder, OfTerrainsInManyBlocks) {
  expect_common_volume(Terrain(24, 9, 5));
}

Solid tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  PolygonMesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.face_sizes = {3, 3, 3, 3};
  mesh.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  return Solid::from_mesh(mesh);
}

TEST(CommonBorder, OfTetrahedraBesideEachOtherAlongAnEdge) {
  const Vec3 p{0, 0, 0}, q{0, 0, 6};
  test::expect_volumes(tetrahedron(p, {6, 1, 0}, {6, 7, 0}, q),
                       tetrahedron(p, {-6, 1, 3}, {-6, -7, 3}, q), 0);
  // The faces of one lie between those of the other one.
  test::expect_volumes(tetrahedron(p, {6, -6, 0}, {6, 6, 0}, q),
                       tetrahedron(p, {3, -1, 3}, {3, 1, 3}, q), 3 * 2 * 6 / 6.0);
}

TEST(CommonBorder, OfTetrahedraWithOneCornerInCommon) {
  const Vec3 p{0, 0, 0};
  test::expect_volumes(tetrahedron(p, {6, 1, 0}, {6, 7, 0}, {5, 3, 6}),
                       tetrahedron(p, {-6, 7, 1}, {-6, 1, 1}, {-5, 3, 6}), 0);
  test::expect_volumes(tetrahedron(p, {6, -6, -6}, {6, 6, -6}, {6, 0, 6}),
                       tetrahedron(p, {3, -1, -1}, {3, 1, -1}, {3, 0, 1}), 2);
}

TEST(CommonBorder, IsNotADiagonalOfAFace) {
  const Solid inner = tetrahedron({0, 0, 0}, {6, 6, 0}, {1, 4, 2}, {4, 1, 2});
  test::expect_volumes(block({0, 0, 0}, {6, 6, 6}), inner, inner.volume());
  const Solid outer = tetrahedron({0, 0, 0}, {6, 6, 0}, {4, 1, -2}, {1, 4, -2});
  test::expect_volumes(block({0, 0, 0}, {6, 6, 6}), outer, 0);
}

// Of a face of many corners, only those near the other one are looked at.
TEST(CommonBorder, OfALargeFaceSaysNothingAboutTheRestOfIt) {
  Profile comb;
  comb.outer = {{0, 0}, {200, 0}, {200, 4}};
  for (int tooth = 99; tooth > 0; --tooth) {
    comb.outer.push_back({2.0 * tooth + 1, 1});
    comb.outer.push_back({2.0 * tooth, 4});
  }
  comb.outer.push_back({0, 4});
  // It has a corner in the bottom of a gap, is below it else, and goes through the plate.
  const Solid nail = tetrahedron({101, 1, 1}, {101.5, 0.25, -3}, {101.5, 0.25, 3}, {100.5, 0.5, 1});
  const Solid below_the_gaps = block({0, 0, 0}, {200, 1, 1});
  test::expect_volumes(extrude(comb, 1), nail,
                       boolean(nail, below_the_gaps, Operation::intersect).volume(), 1e-9);
}

}  // namespace
}  // namespace sectile
