// Stars: walls that begin in one point and stand on a floor. In its plane all their edges have the
// point in common. And walls whose edges run through one point.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "append_mesh.h"
#include "growth/steps.h"
#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/repair.h"
#include "sectile/solid.h"
#include "unit/walls_through_a_point.h"

namespace sectile {
namespace {

// Of these walls only each so-and-so-many-th. They are of one height, or of different ones.
PolygonMesh star(std::size_t walls, std::size_t first = 0, std::size_t by = 1, double rise = 0) {
  PolygonMesh all;
  const double step = 2 * std::numbers::pi / static_cast<double>(walls);
  for (std::size_t i = first; i < walls; i += by) {
    const double a = step * static_cast<double>(i), b = a + 0.5 * step;
    PolygonMesh wall{{}, {3, 3, 4, 4, 4}, {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5}};
    const double top = 1 + rise * static_cast<double>(7919 * i % walls);
    for (const double z : {0.0, top}) {
      wall.positions.push_back({0, 0, z});
      wall.positions.push_back({std::cos(a), std::sin(a), z});
      wall.positions.push_back({std::cos(b), std::sin(b), z});
    }
    test::append(wall, all);
  }
  return all;
}

Solid ground() {
  return block({-2, -2, -1}, {2, 2, 0});
}

TEST(StarGrowth, OnAFloorInABoolean) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth(
                  [&](std::size_t n) {
                    const Solid walls = Solid::from_mesh(star(n));
                    return [=] { boolean(walls, ground(), operation); };
                  },
                  200),
              n_log_n);
}

// They all end in one line.
TEST(StarGrowth, WallsBetweenThoseOfAFloor) {
  for (const double rise : {0.0, 0x1p-12})
    for (const Operation operation : {Operation::unite, Operation::subtract})
      EXPECT_LT(growth(
                    [&](std::size_t n) {
                      const Solid floor = boolean(ground(), Solid::from_mesh(star(n, 0, 2, rise)),
                                                  Operation::unite),
                                  more = Solid::from_mesh(star(n, 1, 2, rise));
                      return [=] { boolean(more, floor, operation); };
                    },
                    400),
                n_log_n);
}

TEST(StarGrowth, OnAFloorAsCells) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const std::vector<Solid> both{Solid::from_mesh(star(n)), ground()};
                  return [both] { cells(both); };
                },
                200),
            n_log_n);
}

TEST(StarGrowth, OnAFloorInARepair) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  PolygonMesh mesh = star(n);
                  test::append(ground().to_mesh(), mesh);
                  return [mesh] { repair(mesh); };
                },
                200),
            n_log_n);
}

test::WallsThroughAPoint walls_through_a_point(std::size_t n, double turn) {
  test::WallsThroughAPoint walls;
  walls.count = static_cast<int>(n);
  walls.turn = turn;
  return walls;
}

// Those of one solid are between those of the other one, or reach into them.
TEST(WallsGrowth, ThroughAPointAsCells) {
  for (const double turn : {0.5, 0.125})
    EXPECT_LT(growth(
                  [turn](std::size_t n) {
                    std::vector<Solid> both;
                    for (const double t : {0.0, turn})
                      both.push_back(Solid::from_mesh(walls_through_a_point(n, t).mesh()));
                    return [both] { cells(both); };
                  },
                  100),
              n_log_n);
}

TEST(WallsGrowth, ThroughAPointInARepair) {
  for (const double turn : {0.5, 0.125})
    EXPECT_LT(growth(
                  [turn](std::size_t n) {
                    PolygonMesh mesh = walls_through_a_point(n, 0).mesh();
                    test::append(walls_through_a_point(n, turn).mesh(), mesh);
                    RepairOptions options;
                    options.rule = Rule::odd;
                    return [=] { repair(mesh, options); };
                  },
                  100),
              n_log_n);
}

// Spikes: their edges have the point in common, and no line. On a floor, of which a corner is there
// between any two of them, each other one.
PolygonMesh spikes(std::size_t n, std::size_t first, std::size_t by) {
  PolygonMesh all;
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = first; i < n; i += by) {
    const double a = step * static_cast<double>(i), b = a + 0.4 * step, c = a + 0.2 * step;
    test::append({{{0, 0, 0},
                   {std::cos(a), std::sin(a), 0},
                   {std::cos(b), std::sin(b), 0},
                   {std::cos(c), std::sin(c), 0.01}},
                  {3, 3, 3, 3},
                  {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}},
                 all);
  }
  return all;
}

TEST(StarGrowth, SpikesBetweenThoseOfAFloor) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth(
                  [&](std::size_t n) {
                    const Solid floor = boolean(ground(), Solid::from_mesh(spikes(n, 0, 2)),
                                                Operation::unite),
                                more = Solid::from_mesh(spikes(n, 1, 2));
                    return [=] { boolean(floor, more, operation); };
                  },
                  400),
              n_log_n);
}

TEST(StarGrowth, SpikesThatFillNotchesOfAFloor) {
  const auto filled = [](std::size_t n) {
    const Solid all = Solid::from_mesh(spikes(n, 0, 1)),
                notches = boolean(block({-2, -2, 0}, {2, 2, 1}), all, Operation::subtract);
    return [=] { boolean(notches, all, Operation::unite); };
  };
  EXPECT_LT(growth(filled, 200), n_log_n);
}

TEST(StarGrowth, SpikesAndAFloorInARepair) {
  const auto all = [](std::size_t n) {
    PolygonMesh mesh = spikes(n, 0, 1);
    test::append(ground().to_mesh(), mesh);
    return [=] { repair(mesh); };
  };
  EXPECT_LT(growth(all, 400), n_log_n);
}

}  // namespace
}  // namespace sectile
