// Very many thin rods in all directions, of two solids, between each other: those that cross are
// found.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr double width = 0x1p-24;

Vec3 sum(const Vec3& p, double times, const Vec3& d) {
  return {p.x + times * d.x, p.y + times * d.y, p.z + times * d.z};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3 unit(const Vec3& a) {
  return sum({0, 0, 0}, 1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z), a);
}

void add_rod(PolygonMesh& mesh, const Vec3& middle, const Vec3& along) {
  const Vec3 u = unit(cross(along, {0.3, 0.1, 1})), v = unit(cross(along, u));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const double end : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * 3.14159265358979 * k / 3;
      mesh.positions.push_back(sum(sum(sum(middle, end, along), width * std::cos(angle), u),
                                   width * std::sin(angle), v));
    }
  const auto add = [&](std::initializer_list<std::uint32_t> corners) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    for (const std::uint32_t c : corners) mesh.indices.push_back(first + c);
  };
  add({2, 1, 0});
  add({3, 4, 5});
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t next = (k + 1) % 3;
    add({k, next, 3 + next});
    add({k, 3 + next, 3 + k});
  }
}

// Rods of a through one ball, and as many of b, of which each crosses one of a.
struct Rods {
  explicit Rods(std::size_t count) {
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random() % 1000000) / 1e6 - 0.5; };
    const auto vector = [&] { return Vec3{number(), number(), number()}; };
    PolygonMesh of_a, of_b;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 middle = sum({0, 0, 0}, 0.2, vector()), along = unit(vector());
      add_rod(of_a, middle, along);
      add_rod(of_b, sum(middle, 0.3 * number(), along), unit(vector()));
    }
    a = Solid::from_mesh(of_a);
    b = Solid::from_mesh(of_b);
  }
  Solid a, b;
};

TEST(CrowdedFaces, ThatCrossAreFound) {
  constexpr std::size_t count = 500;
  const Rods rods(count);
  const Solid common = boolean(rods.a, rods.b, Operation::intersect);
  EXPECT_EQ(common.counts().shells, count);
  const double both = rods.a.volume() + rods.b.volume();
  EXPECT_NEAR(boolean(rods.a, rods.b, Operation::unite).volume(), both - common.volume(),
              1e-12 * both);
}

}  // namespace
}  // namespace sectile
