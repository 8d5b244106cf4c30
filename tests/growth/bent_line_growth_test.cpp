// Walls along one slanted line, which all end elsewhere. When they are written, each gets the ends
// of the others, rounded, as corners: the triangles grow with the square of their number, and all
// that is done with them as the triangles do, but for a logarithm.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "growth/steps.h"
#include "sectile/rounding.h"
#include "sectile/solid.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

constexpr double square_with_log = 1 + n_log_n;

// The same above themselves, as often as there are `storeys`.
Solid walls(std::size_t n, std::size_t storeys = 1) {
  PolygonMesh mesh;
  const std::size_t places = 2 * n;
  for (std::size_t i = 0; i < n; ++i) {
    // Each number from 0 to 2n - 1 is that of one end.
    const std::size_t low = i, high = places - 1 - (3 * i + 1) % n;
    const auto corner = [&](double at, std::size_t z) -> Vec3 {
      const double angle = 2 * std::numbers::pi * at / static_cast<double>(n),
                   far = 16 * static_cast<double>(places);
      return {std::round(far * std::cos(angle)), std::round(far * std::sin(angle)),
              static_cast<double>(z)};
    };
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const double at = static_cast<double>(i);
    mesh.positions.insert(mesh.positions.end(), {{0, 0, static_cast<double>(low)},
                                                 {0, 0, static_cast<double>(high)},
                                                 corner(at, 7 * i % places),
                                                 corner(at + 0.6, 11 * i % places)});
    for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
      mesh.indices.push_back(first + k);
    mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
  }
  const PolygonMesh storey = mesh;
  for (std::size_t i = 1; i < storeys; ++i) {
    for (const Vec3& p : storey.positions)
      mesh.positions.push_back({p.x, p.y, p.z + static_cast<double>(i * places)});
    for (const std::uint32_t k : storey.indices)
      mesh.indices.push_back(static_cast<std::uint32_t>(i * storey.positions.size()) + k);
    mesh.face_sizes.insert(mesh.face_sizes.end(), storey.face_sizes.begin(),
                           storey.face_sizes.end());
  }
  return transformed(Solid::from_mesh(mesh), Transform::rotation_degrees({1, 2, 3}, 40));
}

TEST(BentLineGrowth, WritingWalls) {
  for (const auto numbers : {Rounding::Numbers::doubles, Rounding::Numbers::floats}) {
    Rounding how;
    how.numbers = numbers;
    EXPECT_LT(
        growth([&](std::size_t n) { return [=, book = walls(n)] { rounded_mesh(book, how); }; },
               30),
        square_with_log);
  }
}

// Each wall stays as it is. Most of it is the test whether these cross.
TEST(BentLineGrowth, SeparationOfWalls) {
  Rounding how;
  how.separate_touching = true;
  EXPECT_LT(
      growth([&](std::size_t n) { return [=, book = walls(n)] { rounded_mesh(book, how); }; }, 100),
      1.7);
}

// Each goes off the line within its own material.
TEST(BentLineGrowth, SeparationOfWallsAboveOthersInTheirDirections) {
  Rounding how;
  how.separate_touching = true;
  EXPECT_LT(
      growth([&](std::size_t n) { return [=, book = walls(n, 2)] { rounded_mesh(book, how); }; },
             100),
      1.7);
}

TEST(BentLineGrowth, ReadingWhatWasWritten) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  return [mesh = rounded_mesh(walls(n)).mesh] { Solid::from_mesh(mesh); };
                },
                30),
            square_with_log);
}

}  // namespace
}  // namespace sectile
