// Cells and repairs of walls whose edges all run through one point.
#include "unit/walls_through_a_point.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "append_mesh.h"
#include "cases.h"
#include "sectile/arrangement.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"

namespace sectile {
namespace {

using test::WallsThroughAPoint;

constexpr int many = cases(72);  // fewer are tested one by one, where crowds are not small

WallsThroughAPoint turned(double turn) {
  WallsThroughAPoint walls;
  walls.turn = turn;
  return walls;
}

// A few that reach through many of the others.
WallsThroughAPoint across() {
  WallsThroughAPoint walls = turned(0.25);
  walls.count = 12;
  walls.mirrored = true;
  return walls;
}

PolygonMesh both(const WallsThroughAPoint& walls, const WallsThroughAPoint& others) {
  PolygonMesh mesh = walls.mesh();
  test::append(others.mesh(), mesh);
  return mesh;
}

Solid repaired(const PolygonMesh& mesh, Rule rule) {
  RepairOptions options;
  options.rule = rule;
  return repair(mesh, options);
}

struct Parts {
  Solid only_a, only_b, both;
};

Parts cells_of(const Solid& a, const Solid& b) {
  Parts parts;
  for (SolidCell& cell : cells(std::vector<Solid>{a, b}))
    (cell.operands.size() == 2 ? parts.both
     : cell.operands[0] == 0   ? parts.only_a
                               : parts.only_b) = std::move(cell.solid);
  return parts;
}

// Of an observer, who is shown all that meets, nothing is left out.
Solid shown(const Solid& a, const Solid& b, Operation operation) {
  test::Listener listener;
  BooleanOptions options;
  options.observer = &listener;
  return boolean(a, b, operation, options);
}

void expect_the_cells_of_an_observer(const Solid& a, const Solid& b) {
  const Parts parts = cells_of(a, b);
  EXPECT_TRUE(parts.both == shown(a, b, Operation::intersect));
  EXPECT_TRUE(parts.only_a == shown(a, b, Operation::subtract));
  EXPECT_TRUE(parts.only_b == shown(b, a, Operation::subtract));
  for (const Solid* part : {&parts.both, &parts.only_a, &parts.only_b})
    EXPECT_TRUE(validate(*part).empty());
}

TEST(ArrangedWallsThroughAPoint, BesideEachOtherAreCellsOfTheirOwn) {
  std::vector<Solid> walls;
  for (int i = 0; i < many; ++i) {
    PolygonMesh wall;
    turned(0).add(i, wall);
    walls.push_back(Solid::from_mesh(wall));
  }
  const std::vector<SolidCell> found = cells(walls);
  ASSERT_EQ(found.size(), walls.size());
  for (const SolidCell& cell : found) {
    ASSERT_EQ(cell.operands.size(), 1u);
    EXPECT_TRUE(cell.solid == walls[cell.operands[0]]);
  }
}

TEST(ArrangedWallsThroughAPoint, BesideEachOtherAreRepairedAsTheyAre) {
  const PolygonMesh mesh = both(turned(0), turned(0.5));
  const Solid walls = Solid::from_mesh(mesh);
  for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd})
    EXPECT_TRUE(repaired(mesh, rule) == walls);
}

TEST(ArrangedWallsThroughAPoint, ThatOverlapAreDivided) {
  const Solid a = Solid::from_mesh(turned(0).mesh()), b = Solid::from_mesh(turned(0.125).mesh());
  expect_the_cells_of_an_observer(a, b);
  EXPECT_TRUE(repaired(both(turned(0), turned(0.125)), Rule::odd) ==
              boolean(shown(a, b, Operation::subtract), shown(b, a, Operation::subtract),
                      Operation::unite));
}

TEST(ArrangedWallsThroughAPoint, ThatCrossManyOthersAreDivided) {
  const Solid a = Solid::from_mesh(turned(0).mesh()), b = Solid::from_mesh(across().mesh());
  expect_the_cells_of_an_observer(a, b);
  EXPECT_TRUE(repaired(both(turned(0), across()), Rule::nonzero) == shown(a, b, Operation::unite));
}

TEST(ArrangedWallsThroughAPoint, BesideSpikesThatBeginInItAreNotDivided) {
  PolygonMesh spikes = turned(0.5).mesh();
  for (std::size_t i = 0; i < spikes.positions.size(); i += 8) spikes.positions[i] = {0, 0, 0};
  const Solid a = Solid::from_mesh(turned(0).mesh()), b = Solid::from_mesh(spikes);
  const Parts parts = cells_of(a, b);
  EXPECT_TRUE(parts.only_a == a);
  EXPECT_TRUE(parts.only_b == b);
  EXPECT_TRUE(parts.both.is_empty());
}

// The point is no triple of doubles there.
TEST(ArrangedWallsThroughAPoint, ThatWereMovedAreDivided) {
  const Transform moved = Transform::rotation_degrees({1, 2, 3}, 50);
  expect_the_cells_of_an_observer(transformed(Solid::from_mesh(turned(0).mesh()), moved),
                                  transformed(Solid::from_mesh(turned(0.125).mesh()), moved));
}

}  // namespace
}  // namespace sectile
