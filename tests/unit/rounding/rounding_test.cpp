// What is written is legal when it is read back, says a checker that knows nothing of the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

#include "unit/rounding/legal_rounding.h"

namespace sectile::test {
namespace {

void expect_legal_in_all_numbers(const Solid& solid) {
  expect_legal(solid, to(Numbers::doubles));
  expect_legal(solid, to(Numbers::floats));
}

class NearlyTheSame : public testing::TestWithParam<int> {
 protected:
  static void expect_legal_results(const Solid& a, const Solid& b) {
    for (const Operation operation : {Operation::unite, Operation::intersect})
      expect_legal_in_all_numbers(boolean(a, b, operation));
    // May be thinner than floats can tell, and vanish.
    expect_legal_in_all_numbers(boolean(a, b, Operation::subtract));
  }
};

TEST_P(NearlyTheSame, SpheresBesideThemselves) {
  const Solid a = sphere(1, 16, 8);
  expect_legal_results(a, turned(a, std::pow(10, -GetParam())));
}

TEST_P(NearlyTheSame, CubesBesideThemselves) {
  const Solid a = block({-1, -1, -1}, {1, 1, 1});
  expect_legal_results(a, turned(a, std::pow(10, -GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Rounding, NearlyTheSame, testing::Values(3, 5, 7, 9, 11, 13, 15),
                         [](const auto& test) { return "By1eMinus" + std::to_string(test.param); });

TEST(Rounding, ChainsOfTurnedCubes) {
  const Solid cube = block({-1, -1, -1}, {1, 1, 1});
  Solid all = cube;
  for (int i = 1; i <= 12; ++i) {
    SCOPED_TRACE(i);
    all = boolean(all, turned(cube, 0.37 * i, 0.1 * i),
                  i % 3 == 0 ? Operation::intersect : Operation::unite);
    expect_legal_in_all_numbers(all);
  }
}

// Faces of both come from one face, but do not lie in one plane: no edge between them is a
// diagonal.
TEST(Rounding, ASolidWithItsOwnTurnedCopy) {
  const double t = 1 / 3.0;
  const Transform turn{{t, -2 * t, 2 * t, 0, 2 * t, 2 * t, t, 0, -2 * t, t, 2 * t, 1}};
  for (const Solid& body : {block({0, 0, 0}, {2, 2, 3}), block({0, 0, 1}, {2, 2, 3}),
                            block({2, 0, 0}, {3, 2, 3}), block({1, 2, 1}, {3, 3, 3})})
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
      expect_legal_in_all_numbers(boolean(body, transformed(body, turn), operation));
}

TEST(Rounding, WhatHasItsPlaceStays) {
  const Solid ball = sphere(1, 24, 12);
  const RoundedMesh rounded = expect_legal(ball, to(Numbers::doubles));
  EXPECT_EQ(rounded.report.moved, 0u);
  EXPECT_EQ(rounded.report.largest_move, 0);
  EXPECT_EQ(Solid::from_mesh(rounded.mesh), ball);
}

TEST(Rounding, CoarseGrids) {
  const Solid ball = sphere(10, 24, 12);
  for (const double spacing : {0.25, 0.5, 1.0}) {
    SCOPED_TRACE(spacing);
    const RoundedMesh rounded = expect_legal(ball, to(Numbers::grid, spacing));
    for (const Vec3& p : rounded.mesh.positions)
      for (const double c : {p.x, p.y, p.z}) EXPECT_EQ(std::nearbyint(c / spacing) * spacing, c);
  }
}

// All doubles of that size are nearest to a multiple.
TEST(Rounding, GridsFinerThanDoublesMoveNothing) {
  for (const auto& [size, spacing] : {std::pair(1e17 / 3, 0.3), std::pair(1e300, 1e-300)}) {
    SCOPED_TRACE(size);
    Rounding rounding = to(Numbers::grid, spacing);
    rounding.max_move = 0;
    const Solid cube = block({0, 0, 0}, {size, size, size});
    EXPECT_EQ(Solid::from_mesh(rounded_mesh(cube, rounding).mesh), cube);
  }
}

TEST(Rounding, BoundsTheDisplacement) {
  Rounding rounding = to(Numbers::grid, 0.5);
  rounding.max_move = 1e-3;
  EXPECT_THROW(rounded_mesh(sphere(10, 24, 12), rounding), RoundingFailed);
}

// However little that is.
TEST(Rounding, SaysHowFarACornerWouldMove) {
  Rounding rounding = to(Numbers::floats);
  rounding.max_move = 0;
  try {
    rounded_mesh(block({0, 0, 0}, {1, 1, 0x1p-30 + 0x1p-60}), rounding);
    FAIL();
  } catch (const RoundingFailed& error) {
    EXPECT_NE(std::string(error.what()).find("would move by 8.673617379884035e-19"),
              std::string::npos)
        << error.what();
  }
}

// Five of them in each other, as thin as two steps: corners go to a grid of four steps, and are not
// pushed around among each other for long before.
TEST(Rounding, NeedlesPellMellGoToACoarserGrid) {
  std::mt19937 random(1);
  const auto corner = [&] {
    const double x = random() * 0x1p-32, y = random() * 0x1p-32, z = random() * 0x1p-32;
    return Vec3{1000 * x, 2 * y, 2 * z};
  };
  Solid needles;
  for (int i = 0; i < 5; ++i) {
    const Vec3 a = corner(), b = corner(), c = corner(), d = corner();
    const Solid needle = tetrahedron(a, b, c, d);
    needles = boolean(boolean(needles, needle, Operation::subtract),
                      boolean(needle, needles, Operation::subtract), Operation::unite);
  }
  const RoundedMesh rounded = expect_legal(needles, to(Numbers::grid, 1));
  EXPECT_EQ(rounded.report.resolved, 1u);
  EXPECT_LT(rounded.report.largest_move, 2 + 4 * std::sqrt(3) / 2);  // one to each grid
}

// As points, whatever their order.
std::vector<std::array<double, 9>> triangles_of(const PolygonMesh& mesh) {
  std::vector<std::array<double, 9>> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = mesh.positions[mesh.indices[i + k]];
      p[k] = {at.x, at.y, at.z};
    }
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    triangles.push_back(
        {p[0][0], p[0][1], p[0][2], p[1][0], p[1][1], p[1][2], p[2][0], p[2][1], p[2][2]});
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// How many triangles one mesh has that the other one lacks.
std::size_t difference(const PolygonMesh& a, const PolygonMesh& b) {
  const auto of_a = triangles_of(a), of_b = triangles_of(b);
  std::vector<std::array<double, 9>> only_a;
  std::set_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                      std::back_inserter(only_a));
  return only_a.size();
}

// In solids of many blocks only the surroundings of what moved are looked at, and changed. To
// separate what touches, which is nothing here, the whole is. Which of several diagonals helps may
// be found in another order.
TEST(Rounding, BlockByBlockIsTheSameAsTheWhole) {
  const Solid ball = sphere(1, 64, 32),
              other = transformed(ball, Transform::translation({0.7, 0.31, 0.13}));
  const Solid exact = Solid::from_mesh(other.to_mesh());
  Rounding whole;
  whole.separate_touching = true;
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Solid result = boolean(ball, exact, operation);
    const RoundedMesh plain = expect_legal(result, {}), all = rounded_mesh(result, whole);
    EXPECT_LE(difference(plain.mesh, all.mesh), 2 * (plain.report.flipped + all.report.flipped));
    EXPECT_GT(plain.report.moved, 0u);
    EXPECT_EQ(plain.report.corners, all.report.corners);
    EXPECT_EQ(plain.report.moved, all.report.moved);
    EXPECT_EQ(plain.report.median_move, all.report.median_move);
    EXPECT_EQ(plain.report.largest_move, all.report.largest_move);
    EXPECT_EQ(Solid::from_mesh(plain.mesh).counts().shells, result.counts().shells);
  }
}

RoundingReport sum_of_seams(const Rounding& rounding) {
  const Solid ball = sphere(1, 64, 32);
  RoundingReport sum;
  for (int i = 1; i <= 4; ++i) {
    SCOPED_TRACE(i);
    const Solid other = transformed(ball, Transform::translation({0.21 * i, 0.13 * i, 0.07 * i}));
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      const RoundingReport report = expect_legal(boolean(ball, other, operation), rounding).report;
      sum.flipped += report.flipped;
      sum.displaced += report.displaced;
    }
  }
  return sum;
}

// Where the seam cuts a quad of two flat triangles, it leaves corners of nearly 180°: a triangle
// that is cut off there would be turned over by any rounding.
TEST(Rounding, SeamsOfBallsAreLegalWhereTheirCornersComeToBe) {
  const RoundingReport sum = sum_of_seams({});
  EXPECT_EQ(sum.flipped, 0u);
  EXPECT_EQ(sum.displaced, 0u);
}

// Triangles beside the seam cross once its corners are rounded: edges there are flipped.
TEST(Rounding, SeamsOfBallsOnAGridAreMendedBlockByBlock) {
  Rounding grid;
  grid.numbers = Rounding::Numbers::grid;
  grid.spacing = 0x1p-12;
  EXPECT_GT(sum_of_seams(grid).flipped, 20u);
}

// All corners of both move, and some come to be at one place. What is thin there may vanish, as it
// does where the whole is looked at.
TEST(Rounding, CornersThatACoarseGridJoins) {
  const Solid ball = transformed(sphere(1, 64, 32), Transform::rotation_degrees({1, 1, 3}, 20));
  Rounding coarse;
  coarse.numbers = Rounding::Numbers::grid;
  std::size_t merged = 0;
  for (const double spacing : {0.004, 0.02}) {
    coarse.spacing = spacing;
    Rounding whole = coarse;
    whole.separate_touching = true;
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      const Solid result =
          boolean(ball, transformed(ball, Transform::translation({0.7, 0.31, 0.13})), operation);
      const RoundedMesh written = expect_legal(result, coarse);
      merged += written.report.merged;
      EXPECT_LE(written.report.displaced, written.report.moved);
      EXPECT_EQ(Solid::from_mesh(written.mesh).counts().shells,
                Solid::from_mesh(rounded_mesh(result, whole).mesh).counts().shells);
    }
  }
  EXPECT_GT(merged, 50u);
}

// The small one has corners in one place of the grid, or in a few of one plane.
TEST(Rounding, AShellThatIsTooSmallForTheGridVanishes) {
  const Solid ball = sphere(1, 64, 32), crumb = sphere(0.0004, 12, 8);
  Rounding coarse;
  coarse.numbers = Rounding::Numbers::grid;
  coarse.spacing = 0.002;
  const Solid both =
      boolean(ball, transformed(crumb, Transform::translation({1.5001, 0, 0})), Operation::unite);
  ASSERT_EQ(both.counts().shells, 2u);
  const RoundedMesh written = expect_legal(both, coarse);
  EXPECT_GT(written.report.merged, 0u);
  EXPECT_EQ(Solid::from_mesh(written.mesh).counts().shells, 1u);
  EXPECT_TRUE(rounded_mesh(crumb, coarse).mesh.face_sizes.empty());
}

// Two caps, and what is left of a ball around a hollow.
TEST(Rounding, ShellsOfOneSolid) {
  const Solid ball = sphere(1, 64, 32), core = sphere(0.5, 64, 32),
              slab = turned(block({-2, -2, -0.1}, {2, 2, 0.1}), 0.3);
  const Solid caps = boolean(ball, slab, Operation::subtract);
  const Solid hollow = boolean(boolean(ball, core, Operation::subtract),
                               turned(block({0.8, -2, -2}, {2, 2, 2}), 0.3), Operation::subtract);
  for (const Solid& solid : {caps, hollow}) {
    ASSERT_EQ(solid.counts().shells, 2u);
    const RoundedMesh rounded = expect_legal(solid, {});
    EXPECT_EQ(Solid::from_mesh(rounded.mesh).counts().shells, 2u);
  }
}

// The tip of the small one, `away` from the comb, comes to lie below its base.
Solid comb_and_small_shell(double away) {
  Profile teeth;
  for (int i = 0; i < 32; ++i) {
    teeth.outer.push_back({2.0 * i, 1.0});
    teeth.outer.push_back({2.0 * i + 1, 2.0});
  }
  teeth.outer.push_back({64, 0});
  teeth.outer.push_back({0, 0});
  std::reverse(teeth.outer.begin(), teeth.outer.end());
  const Solid comb = extrude(teeth, 2);
  const double x = 64 + away;
  PolygonMesh small;
  small.positions = {{x, 0, 0.49}, {x + 4, 0, 1.51}, {x, 4, 0.49}, {x + 3, 0.25, 1.3}};
  small.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  small.face_sizes = {3, 3, 3, 3};
  return boolean(comb, Solid::from_mesh(small), Operation::unite);
}

// Of the other one nothing moves.
TEST(Rounding, ASmallShellThatTheGridTurnsInsideOut) {
  const Solid both = comb_and_small_shell(36);
  ASSERT_EQ(both.counts().shells, 2u);
  const RoundedMesh rounded = rounded_mesh(both, to(Numbers::grid, 1));
  EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
  EXPECT_EQ(rounded.report.resolved, 1u);
}

// A corner of it comes to be one of the other, of which nothing moves.
TEST(Rounding, ASmallShellThatTheGridTurnsInsideOutAndPutsOnAnother) {
  const Solid both = comb_and_small_shell(0.25);
  ASSERT_EQ(both.counts().shells, 2u);
  const RoundedMesh rounded = rounded_mesh(both, to(Numbers::grid, 1));
  EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
  EXPECT_EQ(rounded.report.resolved, 1u);
}

// A corner that hardly lies behind a face comes to lie on it: the surroundings tell.
TEST(Rounding, BlockByBlockFindsWhatMeetsAfterwards) {
  const Solid ball = sphere(1, 28, 14);
  for (const double angle : {1e-9, 1e-12, 1e-15}) {
    const Solid other = Solid::from_mesh(turned(ball, angle).to_mesh());
    for (const Operation operation : {Operation::unite, Operation::subtract})
      expect_legal(boolean(ball, other, operation), {});
  }
}

TEST(Rounding, CornersInEdgesOfTheirFaceAreCornersOfTheNeighbour) {
  // The prongs of the upper block's notch end on an edge of the union's face.
  const Solid plate = block({0, 0, 0}, {3, 3, 1});
  const Solid notch = extrude({{{1, 1}, {1.5, 0}, {2, 1}}, {}}, 1);
  const Solid cut = boolean(plate, notch, Operation::subtract);
  expect_legal_in_all_numbers(cut);
  expect_legal_in_all_numbers(turned(cut, 0.4));
}

}  // namespace
}  // namespace sectile::test
