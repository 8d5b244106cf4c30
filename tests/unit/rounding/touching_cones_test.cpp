// Very many wedges of material that touch at one place or along one edge, also within each other,
// are moved apart, and what is written is legal, says a checker that knows nothing of the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sectile/rounding.h"
#include "sectile/sectile.h"
#include "unit/exact_mesh_checker.h"
#include "unit/manifold_check.h"
#include "unit/same_shape.h"

namespace sectile {
namespace {

using Numbers = Rounding::Numbers;

RoundedMesh separated(const Solid& solid, Numbers numbers) {
  Rounding rounding;
  rounding.numbers = numbers;
  rounding.spacing = 0x1p-12;
  rounding.separate_touching = true;
  return rounded_mesh(solid, rounding);
}

std::string fault_of(const Solid& solid, const RoundedMesh& rounded) {
  for (const std::string& fault :
       {test::ExactMeshChecker(rounded.mesh).verdict(), test::manifold_fault(rounded.mesh),
        test::shape_fault(solid, rounded)})
    if (!fault.empty()) return fault;
  return {};
}

void expect_separated(const Solid& solid, std::initializer_list<Numbers> all_numbers) {
  for (const Numbers numbers : all_numbers) {
    SCOPED_TRACE("numbers " + std::to_string(static_cast<int>(numbers)));
    const RoundedMesh rounded = separated(solid, numbers);
    EXPECT_EQ(fault_of(solid, rounded), "");
    if (rounded.report.resolved == 0) {
      EXPECT_GT(rounded.report.separated, 0u);
    }
  }
}

// Also elsewhere, turned so that corners are rounded.
void expect_separated(const Solid& solid) {
  expect_separated(solid, {Numbers::doubles, Numbers::grid});
  expect_separated(transformed(solid, Transform::translation({0.3, 0.2, 0.1}) *
                                          Transform::rotation_degrees({1, 0.3, 0.7}, 20)),
                   {Numbers::doubles, Numbers::floats});
}

// From the origin, around a direction, with three sides or more.
Solid spike(const Vec3& to, double width, int sides) {
  const double size = std::hypot(to.x, to.y, to.z);
  const Vec3 any = std::abs(to.x) < 0.7 * size ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Vec3 a = cross(to, any), u{a.x / size, a.y / size, a.z / size}, b = cross(to, u),
             v{b.x / size, b.y / size, b.z / size};
  PolygonMesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides, c = width * std::cos(angle),
                 s = width * std::sin(angle);
    mesh.positions.push_back(
        {to.x + c * u.x + s * v.x, to.y + c * u.y + s * v.y, to.z + c * u.z + s * v.z});
  }
  const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {p, q, r});
  };
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 1; i <= count; ++i) add(0, i % count + 1, i);
  for (std::uint32_t i = 2; i < count; ++i) add(1, i, i + 1);
  return repair(mesh);
}

// The i-th of n directions all over the sphere.
Vec3 direction(int i, int n) {
  const double z = 1 - (2.0 * i + 1) / n, r = std::sqrt(1 - z * z), a = 2.4 * i;
  return {r * std::cos(a), r * std::sin(a), z};
}

Solid bouquet(int n, double width, int sides) {
  std::vector<Solid> spikes;
  for (int i = 0; i < n; ++i) spikes.push_back(spike(direction(i, n), width, sides));
  return unite(spikes);
}

// What is within angles around the z axis, from z = low to z = high.
Solid wall(double from, double to, double length, double low, double high) {
  PolygonMesh mesh;
  for (const double z : {low, high}) {
    mesh.positions.push_back({0, 0, z});
    for (const double angle : {from, to})
      mesh.positions.push_back({length * std::cos(angle), length * std::sin(angle), z});
  }
  mesh.face_sizes = {3, 3, 4, 4, 4};
  mesh.indices = {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  return Solid::from_mesh(mesh);
}

Solid book(int n) {
  std::vector<Solid> walls;
  const double angle = 2 * std::numbers::pi / n;
  for (int i = 0; i < n; ++i)
    walls.push_back(wall(i * angle, (i + 0.5) * angle, 1 + 0.5 * (i % 3), 0, 1));
  return unite(walls);
}

const Solid& around() {
  static const Solid body = block({-2, -2, -2}, {2, 2, 2});
  return body;
}

TEST(SeparateCrowds, ABook) {
  expect_separated(book(20));
}

// There are a hundred steps, and more, from the edge to the next number in a wall.
TEST(SeparateCrowds, ABookOfWallsThinnerThanSteps) {
  const Solid walls = transformed(book(1600), Transform::translation({0.3, 0.2, 0.1}));
  Rounding rounding;
  rounding.numbers = Numbers::grid;
  rounding.spacing = 0x1p-20;
  rounding.separate_touching = true;
  const RoundedMesh rounded = rounded_mesh(walls, rounding);
  EXPECT_EQ(rounded.report.resolved, 0u);
  EXPECT_EQ(test::manifold_fault(rounded.mesh), "");
  EXPECT_EQ(Solid::from_mesh(rounded.mesh).counts().shells, 1600u);
}

TEST(SeparateCrowds, ABookThatWasCutOut) {
  expect_separated(boolean(around(), book(12), Operation::subtract));
}

TEST(SeparateCrowds, WallsOnAFloorAndBetweenTwo) {
  const Solid on_floor = boolean(block({-2, -2, -1}, {2, 2, 0}), book(10), Operation::unite);
  expect_separated(on_floor);
  expect_separated(boolean(on_floor, block({-2, -2, 1}, {2, 2, 2}), Operation::unite));
}

TEST(SeparateCrowds, TwoStoreysOfWalls) {
  const int n = 8;
  const Solid first = book(n), second = transformed(first, Transform::translation({0, 0, 1}));
  const Solid third = transformed(second, Transform::rotation_degrees({0, 0, 1}, 180.0 / n) *
                                              Transform::translation({0, 0, 1}));
  expect_separated(boolean(first, second, Operation::unite));
  expect_separated(boolean(boolean(first, second, Operation::unite), third, Operation::unite));
}

TEST(SeparateCrowds, ABouquet) {
  expect_separated(bouquet(30, 0.08, 3));
  expect_separated(bouquet(8, 0.2, 7));
}

TEST(SeparateCrowds, ABouquetThatWasCutOut) {
  expect_separated(boolean(around(), bouquet(16, 0.1, 4), Operation::subtract));
}

// Spikes in pits of spikes, whose tips are all in one place: fans have others inside.
TEST(SeparateCrowds, SpikesInPits) {
  const double width = 0.6;
  const Solid pits = boolean(bouquet(2, width, 5), bouquet(2, 0.7 * width, 5), Operation::subtract),
              full = boolean(pits, bouquet(2, 0.4 * width, 4), Operation::unite);
  expect_separated(full, {Numbers::doubles});
  expect_separated(boolean(around(), full, Operation::subtract), {Numbers::doubles});
}

// The same, but only one is hollow, and full of spikes.
TEST(SeparateCrowds, ABouquetInAPit) {
  std::vector<Solid> inner;
  for (int i = 0; i < 6; ++i)
    inner.push_back(spike({0.25 * std::cos(i * 1.0472), 0.25 * std::sin(i * 1.0472), 1}, 0.05, 3));
  const Solid pit =
      boolean(spike({0, 0, 1}, 0.7, 8), spike({0, 0, 1.5}, 0.6, 8), Operation::subtract);
  const Solid with_inner = boolean(pit, unite(inner), Operation::unite);
  std::vector<Solid> all{with_inner};
  for (int i = 0; i < 6; ++i)
    all.push_back(spike({std::cos(i * 1.0472), std::sin(i * 1.0472), -0.5}, 0.1, 3));
  expect_separated(unite(all));
}

// Walls within slots of walls, along one edge.
TEST(SeparateCrowds, WallsInSlots) {
  const int n = 5;
  std::vector<Solid> walls;
  const double angle = 2 * std::numbers::pi / n;
  for (int i = 0; i < n; ++i) {
    const double a = i * angle;
    const Solid slit = boolean(wall(a, a + 0.8 * angle, 1, 0, 1),
                               wall(a + 0.2 * angle, a + 0.6 * angle, 2, i % 2 ? -1 : 0.25, 2),
                               Operation::subtract);
    walls.push_back(
        boolean(slit, wall(a + 0.3 * angle, a + 0.5 * angle, 0.9, 0, 1), Operation::unite));
  }
  expect_separated(unite(walls));
}

// Tetrahedra with corners in few places: much that touches in places and edges, anyhow.
TEST(SeparateCrowds, WhatIsInAnOddNumberOfTetrahedra) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto corner = [&] {
      const auto c = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
      return Vec3{c(), c(), c()};
    };
    Solid all;
    for (int i = 0; i < 5; ++i) {
      PolygonMesh mesh;
      mesh.positions = {{0, 0, 0}, corner(), corner(), corner()};
      mesh.face_sizes = {3, 3, 3, 3};
      mesh.indices = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
      const Solid next = repair(mesh);
      all = boolean(boolean(all, next, Operation::subtract),
                    boolean(next, all, Operation::subtract), Operation::unite);
    }
    for (const Solid& solid :
         {all, transformed(all, Transform::rotation_degrees({1, 0.3, 0.7}, 20))})
      for (const Numbers numbers : {Numbers::doubles, Numbers::floats, Numbers::grid})
        EXPECT_EQ(fault_of(solid, separated(solid, numbers)), "");
  }
}

}  // namespace
}  // namespace sectile
