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
    add_tetrahedron({Vec3{0, 0, low}, Vec3{0, 0, high}, beside(at), beside(at + width)});
  }
  /// The first ones once more, somewhat turned.
  void add_above(std::size_t count, double height, double turn) {
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Vec3, 4> corners = tetrahedron(i);
      const double angle = angle_of(turn), c = std::cos(angle), s = std::sin(angle);
      for (Vec3& p : corners)
        p = {std::round(c * p.x - s * p.y), std::round(s * p.x + c * p.y), p.z + height};
      add_tetrahedron(corners);
    }
  }
  /// The first ones once more, from where their edges end.
  void add_on_top(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Vec3, 4> corners = tetrahedron(i);
      const double height = corners[1].z - corners[0].z;
      for (Vec3& p : corners) p.z += height;
      add_tetrahedron(corners);
    }
  }
  /// One with the tip of a spike on its edge, to the left or to the right of it.
  void add_beside_spike(double low, double high, double width, bool is_left) {
    const double at = directions_[next_] + (is_left ? width + 0.02 : -0.1);
    add(low, high, width);
    const Vec3 tip{0, 0, (low + high) / 2};
    Vec3 right = beside(at), left = beside(at + 0.08), top = beside(at + 0.04);
    right.z = left.z = tip.z - 1;
    top.z = tip.z + 1;
    add_tetrahedron({tip, top, right, left});
  }
  /// From above all walls it goes in another direction.
  void add_with_spike(double low, double high, double width) {
    const double at = directions_[next_++];
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    Vec3 right = beside(at), left = beside(at + width), spike = beside(at + 5);
    right.z = left.z = high;
    spike.z = high + 1000;
    mesh_.positions.insert(mesh_.positions.end(), {{0, 0, low}, {0, 0, high}, right, left, spike});
    for (const std::uint32_t k :
         {0u, 2u, 1u, 0u, 1u, 3u, 2u, 0u, 3u, 1u, 2u, 4u, 2u, 3u, 4u, 3u, 1u, 4u})
      mesh_.indices.push_back(first + k);
    mesh_.face_sizes.insert(mesh_.face_sizes.end(), 6, 3);
  }
  void add_tetrahedron(const std::array<Vec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.insert(mesh_.positions.end(), corners.begin(), corners.end());
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
  std::array<Vec3, 4> tetrahedron(std::size_t i) const {
    return {mesh_.positions[4 * i], mesh_.positions[4 * i + 1], mesh_.positions[4 * i + 2],
            mesh_.positions[4 * i + 3]};
  }
  double angle_of(double direction) const {
    return 2 * std::numbers::pi * direction / double(directions_.size());
  }
  Vec3 beside(double direction) {
    const double angle = angle_of(direction);
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

class LineSeparation : public testing::TestWithParam<Numbers> {
 protected:
  // All is as before but for the ends on the line.
  void expect_whole(const WallsAlongALine& walls) {
    const RoundedMesh apart = expect_separated(turned(Solid::from_mesh(walls.mesh())), GetParam());
    EXPECT_EQ(apart.mesh.face_sizes.size(), walls.mesh().face_sizes.size());
    EXPECT_EQ(apart.report.displaced, apart.report.separated);
    EXPECT_GE(apart.report.separated, walls.mesh().face_sizes.size() / 4);
    EXPECT_EQ(apart.report.merged + apart.report.flipped + apart.report.resolved, 0u);
  }
};

TEST_P(LineSeparation, WallsStayAsTheyAreButForTheirEnds) {
  for (unsigned seed = 0; seed < cases(5u); ++seed) {
    SCOPED_TRACE(seed);
    WallsAlongALine walls(seed);
    walls.add_some(30, 0.6);
    expect_whole(walls);
  }
}

TEST_P(LineSeparation, WallsAboveOthersInTheirDirectionsStayAsTheyAre) {
  WallsAlongALine walls(1);
  walls.add_some(20, 0.6);
  walls.add_above(4, 900, 0);
  walls.add_above(5, 1800, 0.3);
  expect_whole(walls);
}

TEST_P(LineSeparation, WallsOnTopOfOthersStayAsTheyAre) {
  WallsAlongALine walls(1);
  walls.add_some(20, 0.6);
  walls.add_on_top(6);
  expect_whole(walls);
}

// It touches others where they are, and is not cut at their ends if these go.
TEST_P(LineSeparation, AWallThatHasToStayGetsNoEndsOfOthers) {
  WallsAlongALine walls(1);
  walls.add_some(24, 0.6);
  walls.add_with_spike(walls.below(400), 900, 0.6);
  expect_whole(walls);
}

TEST_P(LineSeparation, WallsBesideSpikesStayAsTheyAre) {
  WallsAlongALine walls(1);
  for (int i = 0; i < 17; ++i) {
    const double low = walls.below(400);
    walls.add_beside_spike(low, low + 100 + walls.below(300), 0.3, i % 2 == 0);
  }
  const RoundedMesh apart = expect_separated(turned(repair(walls.mesh())), GetParam());
  EXPECT_EQ(apart.mesh.face_sizes.size(), walls.mesh().face_sizes.size());
}

TEST_P(LineSeparation, WallsStayAsTheyAreIfRoundingMakesOthersMeet) {
  WallsAlongALine walls(1);
  walls.add_some(20, 0.6);
  walls.add_tetrahedron(
      {Vec3{2000, 0, -50}, Vec3{2000, 0, 0}, Vec3{2100, 0, 0}, Vec3{2000, 100, 0}});
  for (int i = 0; i < 8; ++i) {
    const double x = 2005 + 8 * i, y = 5;  // just above the face
    walls.add_tetrahedron(
        {Vec3{x, y, 0x1p-60}, Vec3{x, y, 50}, Vec3{x + 2, y, 50}, Vec3{x, y + 2, 50}});
  }
  const RoundedMesh apart = expect_separated(turned(Solid::from_mesh(walls.mesh())), GetParam());
  EXPECT_EQ(apart.mesh.face_sizes.size(), walls.mesh().face_sizes.size());
  EXPECT_GT(apart.report.displaced, apart.report.separated);
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
