// Booleans of walls whose edges all run through one point.
#include "unit/walls_through_a_point.h"

#include <gtest/gtest.h>

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
using test::WallsThroughAPoint;

constexpr int many = cases(72);  // fewer are tested one by one, where crowds are not small

Solid solid(const WallsThroughAPoint& walls) {
  return Solid::from_mesh(walls.mesh());
}

WallsThroughAPoint turned(double turn) {
  WallsThroughAPoint walls;
  walls.turn = turn;
  return walls;
}

Solid in_both(const Solid& a, const Solid& b) {
  for (const SolidCell& cell : cells(std::vector<Solid>{a, b}))
    if (cell.operands.size() == 2) return cell.solid;
  return {};
}

TEST(WallsThroughAPoint, BesideEachOtherAreInFewPairs) {
  EXPECT_LT(count_pairs(solid(turned(0)), solid(turned(0.5))), std::size_t(40 * many));
}

TEST(WallsThroughAPoint, BesideEachOtherMeetInThePointOnly) {
  const Solid a = solid(turned(0)), b = solid(turned(0.5));
  EXPECT_EQ(boolean(a, b, Operation::unite).counts().shells, std::size_t(2 * many));
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  expect_the_same_for_an_observer(a, b);
}

TEST(WallsThroughAPoint, ThatOverlapAreCut) {
  const Solid a = solid(turned(0)), b = solid(turned(0.125));
  expect_laws_of_sets(a, b);
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == in_both(a, b));
  expect_the_same_for_an_observer(a, b);
}

TEST(WallsThroughAPoint, ThatCrossManyOthersAreCut) {
  WallsThroughAPoint across = turned(0.25);
  across.count = 24;
  across.mirrored = true;
  const Solid a = solid(turned(0)), b = solid(across);
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == in_both(a, b));
  expect_the_same_for_an_observer(a, b);
}

// With edges in common, all over or in parts.
TEST(WallsThroughAPoint, WithThinnerOnesAtTheSameEdges) {
  WallsThroughAPoint thin = turned(0);
  thin.thickness = 0.1;
  thin.depth = 0.5;
  const Solid a = solid(turned(0)), b = solid(thin);
  EXPECT_TRUE(boolean(a, b, Operation::unite) == a);
  expect_the_same_for_an_observer(a, b);
}

TEST(WallsThroughAPoint, ThatPassItByAHair) {
  WallsThroughAPoint passing = turned(0.125);
  for (const double off : {0x1p-30, 0x1p-3}) {
    passing.off = off;
    const Solid a = solid(turned(0)), b = solid(passing);
    expect_laws_of_sets(a, b);
    EXPECT_TRUE(boolean(a, b, Operation::intersect) == in_both(a, b));
  }
}

TEST(WallsThroughAPoint, BesideSpikesThatBeginInIt) {
  PolygonMesh spikes = turned(0.5).mesh();
  for (std::size_t i = 0; i < spikes.positions.size(); i += 8) spikes.positions[i] = {0, 0, 0};
  const Solid a = solid(turned(0)), b = Solid::from_mesh(spikes);
  EXPECT_EQ(boolean(a, b, Operation::unite).counts().shells, std::size_t(2 * many));
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  const Solid c = solid(turned(0.375));
  expect_laws_of_sets(c, b);
  expect_the_same_for_an_observer(c, b);
}

// The point is no triple of doubles there.
TEST(WallsThroughAPoint, ThatWereMoved) {
  const Transform moved = Transform::rotation_degrees({1, 2, 3}, 50);
  const Solid a = transformed(solid(turned(0)), moved),
              beside = transformed(solid(turned(0.5)), moved),
              over = transformed(solid(turned(0.125)), moved);
  EXPECT_EQ(boolean(a, beside, Operation::unite).counts().shells, std::size_t(2 * many));
  expect_laws_of_sets(a, over);
}

}  // namespace
}  // namespace sectile
