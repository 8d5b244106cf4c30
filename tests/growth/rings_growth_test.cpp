// Rings in rings around one point, whose boxes all overlap, and which meet few others each.
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
#include "sectile/transform.h"

namespace sectile {
namespace {

constexpr std::uint32_t corners = 6;

// A whole number of steps, so that rings are flush wherever they are put.
double in_steps(double x) {
  return std::round(x * 0x1p20) * 0x1p-20;
}

// Each loop is about a place that is a bit farther from the origin, for rings that lie aside.
std::vector<Vec2> loop(double radius, double aside) {
  std::vector<Vec2> loop;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double angle = std::numbers::pi * (2 * k + 1) / corners;
    loop.push_back(
        {in_steps(radius * (aside + std::cos(angle))), in_steps(radius * std::sin(angle))});
  }
  return loop;
}

PolygonMesh ring(std::size_t i, double low, double high, double aside) {
  const double inner = 2 * static_cast<double>(i) + 1;
  const Profile profile{loop(inner + 1, aside), {loop(inner, aside)}};
  return transformed(extrude(profile, high - low), Transform::translation({0, 0, low})).to_mesh();
}

PolygonMesh mesh_of_rings(std::size_t n, double low, double high, double aside = 0) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) test::append(ring(i, low, high, aside), mesh);
  return mesh;
}
Solid rings(std::size_t n, double low, double high, double aside = 0) {
  return Solid::from_mesh(mesh_of_rings(n, low, high, aside));
}

// From z = -1 to z = 0.
Solid plate(std::size_t n) {
  const double size = 4 * static_cast<double>(n) + 8;
  return block({-size, -size, -1}, {size, size, 0});
}

Solid slanted(const Solid& solid) {
  return transformed(solid, Transform::rotation_degrees({1, 2, 3}, 33));
}

TEST(Growth, BooleansOfGroovesWithTheRingsThatFillThem) {
  const auto filled = [&](std::size_t n) {
    const Solid all = rings(n, -0.5, 0), grooves = boolean(plate(n), all, Operation::subtract);
    return [=] {
      for (const Operation operation :
           {Operation::unite, Operation::intersect, Operation::subtract})
        boolean(grooves, all, operation);
    };
  };
  EXPECT_LT(growth(filled, 100), n_log_n);
}

TEST(Growth, BooleansOfSlantedGroovesAroundManyPlaces) {
  const auto filled = [&](std::size_t n) {
    const Solid all = rings(n, -0.5, 0, 0.25),
                grooves = boolean(plate(n), all, Operation::subtract);
    return [a = slanted(grooves), b = slanted(all)] { boolean(a, b, Operation::unite); };
  };
  EXPECT_LT(growth(filled, 100), n_log_n);
}

TEST(Growth, BooleansOfRingsThatStandOnRings) {
  const auto on_top = [&](std::size_t n) {
    return [a = slanted(rings(n, 0, 0.5)), b = slanted(rings(n, 0.5, 1))] {
      boolean(a, b, Operation::unite);
    };
  };
  EXPECT_LT(growth(on_top, 100), n_log_n);
}

// Rounded, so that rings cross the floor here and there, which becomes hooks around hooks.
Solid rounded(const Solid& solid) {
  return Solid::from_mesh(slanted(solid).to_mesh());
}

TEST(Growth, BooleansOfRingsOnAFloorWithWhichTheyAreHardlyNotFlush) {
  const auto on_floor = [&](std::size_t n) {
    return
        [a = rounded(plate(n)), b = rounded(rings(n, 0, 0.5))] { boolean(a, b, Operation::unite); };
  };
  EXPECT_LT(growth(on_floor, 100), n_log_n);
}

// Hooks that nearly meet are themselves more than n.
constexpr double as_nearly_flush = 1.5;

TEST(Growth, BooleansThatFillHooksAroundHooks) {
  const auto filled = [](std::size_t n) {
    const Solid all = rounded(rings(n, -0.5, 0)),
                hooks = boolean(rounded(plate(n)), all, Operation::subtract);
    return [=] { boolean(hooks, all, Operation::unite); };
  };
  EXPECT_LT(growth(filled, 100), as_nearly_flush);
}

TEST(Growth, RepairOfRingsAndAFloorWithWhichTheyAreHardlyNotFlush) {
  const auto both = [](std::size_t n) {
    PolygonMesh mesh = slanted(rings(n, 0, 0.5)).to_mesh();
    test::append(slanted(plate(n)).to_mesh(), mesh);
    return [=] { repair(mesh); };
  };
  EXPECT_LT(growth(both, 100), as_nearly_flush);
}

TEST(Growth, UnionOfRingsWithAPlate) {
  const auto all = [](std::size_t n) {
    std::vector<Solid> solids{plate(n)};
    for (std::size_t i = 0; i < n; ++i) solids.push_back(Solid::from_mesh(ring(i, 0, 0.5, 0)));
    return [=] { unite(solids); };
  };
  EXPECT_LT(growth(all, 100), n_log_n);
}

TEST(Growth, CellsOfRingsAndAPlate) {
  const auto both = [](std::size_t n) {
    return [solids = std::vector{plate(n), rings(n, -0.5, 0.5)}] { cells(solids); };
  };
  EXPECT_LT(growth(both, 100), n_log_n);
}

// Of triangles, which are flat patches for the test of the surface.
TEST(Growth, ImportAndRepairOfRings) {
  const auto import = [](std::size_t n) {
    return [mesh = mesh_of_rings(n, 0, 0.5, 0.25)] { Solid::from_mesh(mesh); };
  };
  EXPECT_LT(growth(import, 100), n_log_n);
  const auto on_plate = [](std::size_t n) {
    PolygonMesh mesh = mesh_of_rings(n, 0, 0.5, 0.25);
    test::append(plate(n).to_mesh(), mesh);
    return [=] { repair(mesh); };
  };
  EXPECT_LT(growth(on_plate, 100), n_log_n);
}

}  // namespace
}  // namespace sectile
