#include <gtest/gtest.h>

#include "growth/steps.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

Solid sphere_of(std::size_t triangles) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  return sphere(1, 2 * rings, rings);
}

TEST(Steps, AreCountedAlikeEachTime) {
  const PolygonMesh mesh = sphere_of(1000).to_mesh();
  const auto work = [&] { Solid::from_mesh(mesh); };
  work();
  EXPECT_EQ(steps_of(work), steps_of(work));
}

TEST(Steps, TellLinearFromQuadraticGrowth) {
  const PolygonMesh mesh = sphere_of(1000).to_mesh();
  const auto repeated = [&](std::size_t times) {
    return [&mesh, times] {
      for (std::size_t i = 0; i < times; ++i) Solid::from_mesh(mesh);
    };
  };
  EXPECT_LT(growth([&](std::size_t n) { return repeated(n); }, 2), n_log_n);
  EXPECT_GT(growth([&](std::size_t n) { return repeated(n * n); }, 2), 1.9);
}

TEST(Growth, ImportOfASphere) {
  EXPECT_LT(
      growth(
          [](std::size_t n) { return [mesh = sphere_of(n).to_mesh()] { Solid::from_mesh(mesh); }; },
          4000),
      n_log_n);
}

TEST(Growth, UnionOfTwoSpheres) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid a = sphere_of(n),
                              b = transformed(a, Transform::translation({0.7, 0.1, 0.05}));
                  return [a, b] { boolean(a, b, Operation::unite); };
                },
                4000),
            n_log_n);
}

}  // namespace
}  // namespace sectile
