// Walls along one slanted line, between ends of their own, as manifolds: each is moved off the line
// as a whole, and gets no corners of others.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "cases.h"
#include "unit/manifold_check.h"
#include "unit/rounding/legal_rounding.h"

namespace sectile {
namespace {

using test::Numbers;

// Walls that are tetrahedra along the z axis, each in a direction of its own.
class WallsAlongALine {
 public:
  explicit WallsAlongALine(unsigned seed) : random_(seed) {
    std::iota(directions_.begin(), directions_.end(), 0);
    std::ranges::shuffle(directions_, random_);
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  /// `width`: as part of the way from one direction to the next.
  void add(double low, double high, double width) {
    const double at = directions_[next_++];
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.insert(mesh_.positions.end(),
                           {{0, 0, low}, {0, 0, high}, beside(at), beside(at + width)});
    for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
      mesh_.indices.push_back(first + k);
    mesh_.face_sizes.insert(mesh_.face_sizes.end(), 4, 3);
  }
  void add_some(int count, double width) {
    for (int i = 0; i < count; ++i) {
      const double low = below(400);
      add(low, low + 1 + below(400), width);
    }
  }
  const PolygonMesh& mesh() const { return mesh_; }

 private:
  Vec3 beside(double direction) {
    const double angle = 2 * std::numbers::pi * direction / double(directions_.size());
    return {std::round(640 * std::cos(angle)), std::round(640 * std::sin(angle)),
            double(below(800))};
  }

  std::mt19937 random_;
  std::array<int, 60> directions_{};
  std::size_t next_ = 0;
  PolygonMesh mesh_;
};

Solid turned(const Solid& solid) {
  return transformed(
      solid, Transform::translation({0.3, 0.2, 0.1}) * Transform::rotation_degrees({1, 2, 3}, 40));
}

RoundedMesh expect_separated(const Solid& solid, Numbers numbers) {
  Rounding how = test::to(numbers, 0x1p-20);
  how.separate_touching = true;
  RoundedMesh apart = test::expect_legal(solid, how);
  EXPECT_EQ(test::manifold_fault(apart.mesh), "");
  return apart;
}

class LineSeparation : public testing::TestWithParam<Numbers> {};

TEST_P(LineSeparation, WallsStayAsTheyAreButForTheirEnds) {
  for (unsigned seed = 0; seed < cases(5u); ++seed) {
    SCOPED_TRACE(seed);
    WallsAlongALine walls(seed);
    walls.add_some(30, 0.6);
    const RoundedMesh apart = expect_separated(turned(Solid::from_mesh(walls.mesh())), GetParam());
    EXPECT_EQ(apart.mesh.face_sizes.size(), 4u * 30);
    EXPECT_EQ(apart.report.displaced, apart.report.separated);
    EXPECT_GE(apart.report.separated, 40u);
    EXPECT_EQ(apart.report.merged + apart.report.flipped + apart.report.resolved, 0u);
  }
}

// No part of space around the line is that of one wall only, all along it.
TEST_P(LineSeparation, WallsInOneDirectionGetEachOthersEnds) {
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    SCOPED_TRACE(seed);
    WallsAlongALine walls(seed);
    walls.add_some(12, 0.6);
    PolygonMesh mesh = walls.mesh();
    for (int i = 0; i < 4; ++i) {  // above the others
      const std::array<Vec3, 4> c{mesh.positions[4 * i], mesh.positions[4 * i + 1],
                                  mesh.positions[4 * i + 2], mesh.positions[4 * i + 3]};
      for (const Vec3& p : c) mesh.positions.push_back({p.x, p.y, p.z + 900});
      for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size() - 4) + k);
      mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
    }
    expect_separated(turned(repair(mesh)), GetParam());
  }
}

TEST_P(LineSeparation, WallsOnBothSidesOfABlocksEdge) {
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    SCOPED_TRACE(seed);
    WallsAlongALine walls(seed);
    walls.add_some(24, 0.6);
    const Solid both = boolean(repair(walls.mesh()), block({-100, -100, -50}, {0, 0, 900}),
                               seed % 2 == 0 ? Operation::unite : Operation::subtract);
    expect_separated(turned(both), GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Rounding, LineSeparation,
                         testing::Values(Numbers::doubles, Numbers::floats, Numbers::grid));

}  // namespace
}  // namespace sectile
