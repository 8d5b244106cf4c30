// Rings in rings around one point: the boxes of all their faces overlap, and each meets few others.
#include <gtest/gtest.h>

#include <vector>

#include "append_mesh.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "volumes.h"

namespace sectile {
namespace {

constexpr int count = 24;

// Squares of which the corners are whole numbers: all volumes are, too.
std::vector<Vec2> square(double size) {
  return {{-size, -size}, {size, -size}, {size, size}, {-size, size}};
}

// Between the squares of sizes 2 i + 1 and 2 i + 2.
Profile ring(int i) {
  return {square(2 * i + 2), {square(2 * i + 1)}};
}
double area(int i) {
  return 4.0 * ((2 * i + 2) * (2 * i + 2) - (2 * i + 1) * (2 * i + 1));
}

// The same with a slit: a hook around those within.
Profile hook(int i) {
  const double outer = 2 * i + 2, inner = 2 * i + 1;
  return {{{outer, 1},
           {outer, outer},
           {-outer, outer},
           {-outer, -outer},
           {outer, -outer},
           {outer, 0},
           {inner, 0},
           {inner, -inner},
           {-inner, -inner},
           {-inner, inner},
           {inner, inner},
           {inner, 1}},
          {}};
}

Solid standing(const Profile& profile, double low, double height) {
  return transformed(extrude(profile, height), Transform::translation({0, 0, low}));
}

std::vector<Solid> rings(double low, double height, int many = count) {
  std::vector<Solid> all;
  for (int i = 0; i < many; ++i) all.push_back(standing(ring(i), low, height));
  return all;
}
std::vector<Solid> hooks(double low, double height) {
  std::vector<Solid> all;
  for (int i = 1; i < count; ++i) all.push_back(standing(hook(i), low, height));
  return all;
}

double area_of_rings() {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += area(i);
  return sum;
}

constexpr double size = 2 * count + 2;
Solid plate() {
  return block({-size, -size, -2}, {size, size, 0});
}
constexpr double area_of_plate = 4 * size * size;

Solid slanted(const Solid& solid) {
  return transformed(solid, Transform::rotation_degrees({1, 2, 3}, 33));
}

TEST(RingsInRings, FillTheirGrooves) {
  const Solid all = unite(rings(-1, 1)), grooves = boolean(plate(), all, Operation::subtract);
  EXPECT_EQ(all.volume(), area_of_rings());
  EXPECT_EQ(grooves.volume(), 2 * area_of_plate - area_of_rings());
  test::expect_volumes(grooves, all, 0);
  EXPECT_TRUE(boolean(grooves, all, Operation::unite) == plate());
}

TEST(RingsInRings, StandInDeeperGroovesThanTheyFill) {
  const Solid high = unite(rings(-1, 2)), low = unite(rings(-0.5, 0.5));
  const Solid grooves = boolean(plate(), high, Operation::subtract);
  test::expect_volumes(grooves, low, 0);
  test::expect_volumes(high, low, area_of_rings() / 2);
}

TEST(RingsInRings, StandOnAPlateAndOnEachOther) {
  const Solid low = unite(rings(0, 1)), high = unite(rings(1, 1));
  test::expect_volumes(plate(), low, 0);
  test::expect_volumes(low, high, 0);
  EXPECT_EQ(boolean(low, high, Operation::unite).counts().shells, std::size_t(count));
}

TEST(RingsInRings, WithSlitsAreRingsButForTheSlits) {
  const Solid whole = unite(rings(-1, 1)), slit = unite(hooks(-1, 1));
  test::expect_volumes(whole, slit, slit.volume());
  EXPECT_EQ(boolean(whole, slit, Operation::subtract).volume(), area(0) + (count - 1));
  test::expect_volumes(boolean(plate(), whole, Operation::subtract), slit, 0);
}

// The two cross twice in a cube, and others do not meet.
TEST(RingsInRings, CrossRingsInAnotherDirection) {
  const Solid flat = unite(rings(-0.5, 1)),
              upright = transformed(flat, Transform::rotation_degrees({1, 0, 0}, 90));
  test::expect_volumes(flat, upright, 2 * count, 1e-9);
}

// Boxes alone would leave more pairs than are few, whatever is taken for few.
TEST(RingsInRings, OfVeryManyFillTheirGrooves) {
  const Solid all = unite(rings(-1, 1, 120)), floor = block({-300, -300, -2}, {300, 300, 0}),
              grooves = boolean(floor, all, Operation::subtract);
  EXPECT_EQ(grooves.volume(), floor.volume() - all.volume());
  EXPECT_TRUE(boolean(grooves, all, Operation::intersect).is_empty());
  EXPECT_EQ(boolean(grooves, all, Operation::subtract).volume(), grooves.volume());
  const Solid filled = boolean(slanted(grooves), slanted(all), Operation::unite);
  EXPECT_TRUE(filled == slanted(floor));
  EXPECT_EQ(filled.counts().faces, 6u + 2 * 120u);
}

TEST(RingsInRings, SlantedAreWhatTheyWereBefore) {
  const Solid all = unite(rings(-1, 1)), grooves = boolean(plate(), all, Operation::subtract);
  EXPECT_TRUE(boolean(slanted(grooves), slanted(all), Operation::unite) == slanted(plate()));
  EXPECT_TRUE(boolean(slanted(grooves), slanted(all), Operation::intersect).is_empty());
}

// Slanted and rounded, they cross the floor by less than a hair here and there, and hooks around
// hooks are cut out of it.
TEST(RingsInRings, StandOnAFloorWithWhichTheyAreHardlyNotFlush) {
  const auto rounded = [](const Solid& solid) {
    return Solid::from_mesh(slanted(solid).to_mesh());
  };
  const Solid floor = rounded(plate());
  for (const int n : {8, 40}) {
    const Solid all = rounded(unite(rings(0, 1, n))), both = boolean(floor, all, Operation::unite);
    EXPECT_NEAR(both.volume(), floor.volume() + all.volume(), 1e-9);
    EXPECT_NEAR(boolean(floor, all, Operation::subtract).volume(), floor.volume(), 1e-9);
    EXPECT_NEAR(boolean(all, floor, Operation::subtract).volume(), all.volume(), 1e-9);
    EXPECT_TRUE(validate(both).empty());
    EXPECT_TRUE(boolean(both, floor, Operation::unite) == both);
    EXPECT_TRUE(boolean(boolean(both, all, Operation::subtract), all, Operation::unite) == both);
  }
}

// Each ring is a shell in a block of its own.
TEST(RingsInRings, LieBetweenOthers) {
  const int many = 280;
  PolygonMesh even, odd;
  for (int i = 0; i < many; ++i)
    test::append(standing(ring(i), 0, 1).to_mesh(), i % 2 == 0 ? even : odd);
  const Solid a = slanted(Solid::from_mesh(even)), b = slanted(Solid::from_mesh(odd)),
              both = boolean(a, b, Operation::unite);
  EXPECT_EQ(both.counts().shells, std::size_t(many));
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(both, b, Operation::subtract) == a);
}

TEST(RingsInRings, AreTheSameForAnObserver) {
  const Solid all = unite(rings(-1, 1)), grooves = boolean(plate(), all, Operation::subtract);
  test::expect_the_same_for_an_observer(grooves, all);
  test::expect_the_same_for_an_observer(slanted(all), slanted(unite(hooks(-0.5, 1))));
}

TEST(RingsInRings, AreCellsOfTheirOwn) {
  std::vector<Solid> solids = rings(-1, 2);
  solids.push_back(plate());
  const std::vector<SolidCell> found = cells(solids);
  ASSERT_EQ(found.size(), std::size_t(2 * count + 1));
  for (const SolidCell& cell : found) {
    const std::uint32_t first = cell.operands.front();
    EXPECT_EQ(cell.solid.volume(),
              first == count ? 2 * area_of_plate - area_of_rings() : area(int(first)));
    EXPECT_TRUE(validate(cell.solid).empty());
  }
}

TEST(RingsInRings, AreRepairedInOneSoup) {
  PolygonMesh mesh = plate().to_mesh();
  for (const Solid& ring : rings(-1, 2)) test::append(ring.to_mesh(), mesh);
  for (const Rule rule : {Rule::positive, Rule::nonzero}) {
    RepairOptions options;
    options.rule = rule;
    EXPECT_EQ(repair(mesh, options).volume(), 2 * area_of_plate + area_of_rings());
  }
  RepairOptions odd;
  odd.rule = Rule::odd;
  EXPECT_EQ(repair(mesh, odd).volume(), 2 * area_of_plate);
}

// Of so many corners that each end of a ring is a flat patch of many triangles.
Solid round_ring(double radius, double low) {
  return transformed(
      boolean(cylinder(radius + 1, 1, 24), cylinder(radius, 1, 24), Operation::subtract),
      Transform::translation({0, 0, low}));
}

TEST(RingsInRings, AreImportedUnlessOneCrossesAnother) {
  PolygonMesh mesh;
  double volume = 0;
  for (int i = 1; i <= count; ++i) {
    test::append(round_ring(2 * i, 0).to_mesh(), mesh);
    volume += round_ring(2 * i, 0).volume();
  }
  const Solid all = Solid::from_mesh(mesh);
  EXPECT_NEAR(all.volume(), volume, 1e-9 * volume);
  EXPECT_EQ(all.counts().shells, std::size_t(count));
  EXPECT_TRUE(Solid::from_mesh(all.to_mesh()) == all);
  for (const double radius : {2.5, 11.5, 2 * count - 0.5}) {
    PolygonMesh crossing = mesh;
    test::append(round_ring(radius, 0).to_mesh(), crossing);
    EXPECT_THROW(Solid::from_mesh(crossing), InvalidSolid) << radius;
  }
}

}  // namespace
}  // namespace sectile
