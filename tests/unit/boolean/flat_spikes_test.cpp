// Spikes that begin in one point, flat and aslant, so that the directions of each are in the boxes
// of very many others.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "append_mesh.h"
#include "cases.h"
#include "sectile/arrangement.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"
#include "unit/pairs_near.h"

namespace sectile {
namespace {

using test::count_pairs;
using test::expect_laws_of_sets;
using test::expect_the_same_for_an_observer;

constexpr int many = cases(64);

// Around an axis, all turned by so much of a step, and inclined against the plane around it.
Solid flat_spikes(double turn, double incline, int count = many) {
  PolygonMesh mesh;
  const double step = 2 * std::numbers::pi / many;
  for (int i = 0; i < count; ++i) {
    const double a = step * (i + turn), up = std::sin(incline), along = std::cos(incline);
    const auto at = [&](double beside, double above) -> Vec3 {
      const double t = beside * along - above * up, z = beside * up + above * along;
      return {16 * std::cos(a) - 16 * t * std::sin(a), 16 * std::sin(a) + 16 * t * std::cos(a),
              16 * z};
    };
    test::append({{{0, 0, 0}, at(-0.9, -0.01), at(0.9, -0.01), at(0, 0.01)},
                  {3, 3, 3, 3},
                  {0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3}},
                 mesh);
  }
  return Solid::from_mesh(mesh);
}

// One vertex of each, and what is near it, meets all faces of the other one.
TEST(FlatSpikes, BesideEachOtherAreInFewPairs) {
  const Solid a = flat_spikes(0, 0.7), b = flat_spikes(0.5, 0.7);
  EXPECT_LT(count_pairs(a, b), std::size_t(12 * many));
}

TEST(FlatSpikes, BesideEachOtherMeetInOnePoint) {
  const Solid a = flat_spikes(0, 0.7), b = flat_spikes(0.5, 0.7);
  EXPECT_EQ(boolean(a, b, Operation::unite).counts().shells, std::size_t(2 * many));
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  expect_the_same_for_an_observer(a, b);
}

TEST(FlatSpikes, ThatCrossEachOtherAreCut) {
  const Solid a = flat_spikes(0, 0.7), b = flat_spikes(0.25, -0.7, 9);
  expect_laws_of_sets(a, b);
  expect_the_same_for_an_observer(a, b);
  Solid both;
  for (const SolidCell& cell : cells(std::vector<Solid>{a, b}))
    if (cell.operands.size() == 2) both = cell.solid;
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == both);
}

// With their edges in common, or one in the other, all over a small turn.
TEST(FlatSpikes, ThatOverlapAreWhatTheyAreForAnObserver) {
  const Solid a = flat_spikes(0, 0.7);
  for (const double turn : {0.0, 0x1p-30, 0.01}) expect_laws_of_sets(a, flat_spikes(turn, 0.7, 20));
  const Solid moved = transformed(a, Transform::rotation_degrees({1, 2, 3}, 1));
  expect_the_same_for_an_observer(a, moved);
}

}  // namespace
}  // namespace sectile
