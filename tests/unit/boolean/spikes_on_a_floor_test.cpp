// Floors on which spikes stand that all begin in one point: there the floor's face has a corner
// between any two of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "append_mesh.h"
#include "cases.h"
#include "sectile/arrangement.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"

namespace sectile {
namespace {

using test::expect_laws_of_sets;
using test::expect_the_same_for_an_observer;

constexpr int many = cases(96);
constexpr double room = 0.4;  // that a spike takes of a step
const double step = 2 * std::numbers::pi / many;

Vec3 at(double angle, double height = 0) {
  return {4 * std::cos(angle), 4 * std::sin(angle), height};
}

// Turned by so much of a step; of these only each so-and-so-many-th. They point down if the height
// is negative.
Solid spikes(double turn, int by = 1, double height = 1) {
  PolygonMesh mesh;
  for (int i = 0; i < many; i += by) {
    const double a = step * (i + turn), b = a + room * step;
    PolygonMesh spike{{{0, 0, 0}, at(a), at(b), at((a + b) / 2, std::abs(height))},
                      {3, 3, 3, 3},
                      {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
    if (height < 0) spike = transformed(spike, Transform::scaling({1, 1, -1}));
    test::append(spike, mesh);
  }
  return Solid::from_mesh(mesh);
}

// A spike's volume is that of a pyramid.
double volume(int count) {
  return count * 16 * std::sin(room * step) / 6;
}

Solid below() {
  return block({-8, -8, -2}, {8, 8, 0});
}
Solid above() {
  return block({-8, -8, 0}, {8, 8, 2});
}
Solid with_spikes(double turn, int by = 1) {
  return boolean(below(), spikes(turn, by), Operation::unite);
}
// The spikes' room is left below a block.
Solid with_notches(double turn, int by = 1) {
  return boolean(above(), spikes(turn, by), Operation::subtract);
}

TEST(SpikesOnAFloor, MoreOfThemBetweenThem) {
  const Solid floor = with_spikes(0), more = spikes(0.5);
  EXPECT_NEAR(floor.volume(), 512 + volume(many), 1e-9);
  EXPECT_NEAR(boolean(floor, more, Operation::unite).volume(), 512 + volume(2 * many), 1e-9);
  expect_laws_of_sets(floor, more);
  expect_laws_of_sets(more, floor);
  expect_the_same_for_an_observer(floor, more);
}

TEST(SpikesOnAFloor, ThatAreThereAlreadyChangeNothing) {
  const Solid floor = with_spikes(0);
  EXPECT_TRUE(boolean(floor, spikes(0, 3), Operation::unite) == floor);
  EXPECT_TRUE(boolean(spikes(0, 3), floor, Operation::unite) == floor);
  EXPECT_TRUE(boolean(floor, spikes(0), Operation::subtract) == below());
}

TEST(SpikesOnAFloor, ThatFillNotches) {
  const Solid notches = with_notches(0);
  EXPECT_NEAR(notches.volume(), 512 - volume(many), 1e-9);
  EXPECT_TRUE(boolean(notches, spikes(0), Operation::unite) == above());
  EXPECT_TRUE(boolean(notches, spikes(0), Operation::intersect).is_empty());
  const Solid half = boolean(notches, spikes(0, 2), Operation::unite);
  EXPECT_NEAR(half.volume(), 512 - volume(many / 2), 1e-9);
  EXPECT_TRUE(validate(half).empty());
}

TEST(SpikesOnAFloor, UnderAFloorWithNotches) {
  const Solid a = with_spikes(0), b = with_notches(0);
  EXPECT_TRUE(boolean(a, b, Operation::unite) == block({-8, -8, -2}, {8, 8, 2}));
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  expect_laws_of_sets(a, with_notches(0.5));
  expect_laws_of_sets(a, with_notches(0.2));
}

TEST(SpikesOnAFloor, ThatOverlapOthers) {
  const double turn = 0.1, common = (room - turn) / room;
  const Solid floor = with_spikes(0), more = spikes(turn);
  EXPECT_LT(boolean(floor, more, Operation::intersect).volume(), common * volume(many));
  expect_laws_of_sets(floor, more);
  expect_the_same_for_an_observer(floor, more);
}

TEST(SpikesOnAFloor, BelowItThatBeginWhereOthersStand) {
  const Solid floor = with_spikes(0), dug = spikes(0.5, 1, -1);
  EXPECT_NEAR(boolean(floor, dug, Operation::intersect).volume(), volume(many), 1e-9);
  expect_laws_of_sets(floor, dug);
  expect_laws_of_sets(boolean(floor, dug, Operation::subtract), spikes(0.5, 2));
}

TEST(SpikesOnAFloor, AroundTwoPlaces) {
  const Solid aside = transformed(spikes(0.3), Transform::translation({1, 0.5, 0}));
  const Solid floor = boolean(below(), unite(std::vector{spikes(0, 2), aside}), Operation::unite);
  expect_laws_of_sets(floor, spikes(1.3, 2));
  expect_laws_of_sets(floor, transformed(spikes(0.8), Transform::translation({1, 0.5, 0})));
}

TEST(SpikesOnAFloor, Slanted) {
  const Transform slant = Transform::rotation_degrees({1, 2, 3}, 33);
  expect_laws_of_sets(transformed(with_spikes(0), slant), transformed(spikes(0.5), slant));
  expect_laws_of_sets(transformed(with_spikes(0), slant), transformed(with_notches(0.1), slant));
}

TEST(SpikesOnAFloor, AndPartsThatGoThroughThePoint) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-3, 3);
  const Solid floor = with_spikes(0);
  for (int i = 0; i < cases(12); ++i) {
    const Vec3 p{any(random), any(random), any(random)}, q{any(random), any(random), 0};
    const PolygonMesh mesh{{{0, 0, 0}, p, q, {-p.x, -p.y, -p.z + 1}},
                           {3, 3, 3, 3},
                           {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
    RepairOptions any_way_around;
    any_way_around.rule = Rule::nonzero;
    expect_laws_of_sets(floor, repair(mesh, any_way_around));
  }
}

TEST(SpikesOnAFloor, ARepairUnitesThem) {
  PolygonMesh mesh = below().to_mesh();
  test::append(spikes(0).to_mesh(), mesh);
  const Solid made = repair(mesh);
  EXPECT_TRUE(made == with_spikes(0));
}

}  // namespace
}  // namespace sectile
