// Floors on which walls of different heights stand that all end in one line: in its foot the
// floor's face has a corner between any two of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "append_mesh.h"
#include "cases.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"

namespace sectile {
namespace {

using test::expect_laws_of_sets;
using test::expect_the_same_for_an_observer;

constexpr int steps = cases(96);  // around the line
constexpr double long_enough = 4;

struct Wall {
  int direction;  // in steps; it is one step wide
  double low, high;

  PolygonMesh mesh() const {
    PolygonMesh mesh{{}, {3, 3, 4, 4, 4}, {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5}};
    for (const double z : {low, high}) {
      mesh.positions.push_back({0, 0, z});
      for (const int end : {direction, direction + 1}) {
        const double angle = 2 * std::numbers::pi * end / steps;
        mesh.positions.push_back({long_enough * std::cos(angle), long_enough * std::sin(angle), z});
      }
    }
    return mesh;
  }
  double volume() const {
    return (high - low) * long_enough * long_enough * std::sin(2 * std::numbers::pi / steps) / 2;
  }
};

using Walls = std::vector<Wall>;

// No two of a height, one after the other around the line.
Walls every(int by, int first) {
  Walls walls;
  for (int d = first; d < steps; d += by)
    walls.push_back({d, 0, 1 + static_cast<double>((7 * d) % steps) / steps});
  return walls;
}

Solid solid(const Walls& walls) {
  PolygonMesh mesh;
  for (const Wall& wall : walls) test::append(wall.mesh(), mesh);
  return Solid::from_mesh(mesh);
}
double volume(const Walls& walls) {
  double sum = 0;
  for (const Wall& wall : walls) sum += wall.volume();
  return sum;
}

Solid ground() {
  return block({-8, -8, -2}, {8, 8, 0});
}
Solid on_ground(const Walls& walls) {
  return boolean(ground(), solid(walls), Operation::unite);
}

TEST(WallsOnAFloor, MoreOfThemBetweenThem) {
  const Walls some = every(4, 0), others = every(4, 2);
  const Solid floor = on_ground(some), more = solid(others);
  EXPECT_NEAR(floor.volume(), 512 + volume(some), 1e-9);
  EXPECT_NEAR(boolean(floor, more, Operation::unite).volume(), 512 + volume(some) + volume(others),
              1e-9);
  EXPECT_TRUE(boolean(floor, more, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(more, floor, Operation::subtract) == more);
  expect_laws_of_sets(floor, more);
  expect_the_same_for_an_observer(floor, more);
}

TEST(WallsOnAFloor, ThatAreThereAlreadyChangeNothing) {
  const Solid floor = on_ground(every(2, 0));
  EXPECT_TRUE(boolean(floor, solid(every(4, 2)), Operation::unite) == floor);
  EXPECT_TRUE(boolean(floor, solid(every(2, 0)), Operation::subtract) == ground());
}

TEST(WallsOnAFloor, ThatFillNotches) {
  const Walls all = every(2, 0), half = every(4, 0);
  const Solid above = block({-8, -8, 0}, {8, 8, 4}),
              notches = boolean(above, solid(all), Operation::subtract);
  EXPECT_NEAR(notches.volume(), 1024 - volume(all), 1e-9);
  EXPECT_TRUE(boolean(notches, solid(all), Operation::unite) == above);
  EXPECT_NEAR(boolean(notches, solid(half), Operation::unite).volume(),
              1024 - volume(all) + volume(half), 1e-9);
  expect_laws_of_sets(notches, on_ground(all));
}

// Some hang above the floor, or reach into it.
TEST(WallsOnAFloor, AnyOfThem) {
  for (unsigned seed = 0; seed < cases(6u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const auto any = [&](int by, int first) {
      Walls walls = every(by, first);
      for (Wall& wall : walls) {
        wall.low = below(3) == 0 ? 0.5 * (below(3) - 1) : 0;
        wall.high = 1 + 0.125 * below(24);
      }
      return walls;
    };
    const Transform slant = Transform::rotation_degrees({1, 2, 3}, 33 * below(2));
    const Solid a = transformed(on_ground(any(2, 0)), slant),
                b = transformed(below(2) == 0 ? solid(any(2, 1)) : on_ground(any(2, below(2))),
                                slant);
    expect_laws_of_sets(a, b);
    expect_the_same_for_an_observer(a, b);
  }
}

}  // namespace
}  // namespace sectile
