// Where no box of one solid is, the other one lies on one side of its boundary: what is told so is
// so, and labels reach what hangs together with nothing else.
#include "boolean/components/clear_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = ClearRegions::none, beyond = ClearRegions::beyond;

// Turned, so that no two triangles are coplanar: those that are come into blocks of their own.
Solid ball(const Vec3& centre, double radius, std::uint32_t fine = 1) {
  return Solid::from_mesh(
      transformed(sphere_mesh({0, 0, 0}, radius, 60 * fine, 40 * fine),
                  Transform::translation(centre) * Transform::rotation_degrees({1, 2, 3}, 33)));
}

ClearRegions regions(const Solid& solid, const Solid& other) {
  return clear_regions(*solid.data(), *other.data());
}

std::set<std::uint32_t> all_of(const ClearRegions& regions) {
  return {regions.of_slot.begin(), regions.of_slot.end()};
}

TEST(ClearRegions, WhatIsFarIsBeyond) {
  EXPECT_EQ(all_of(regions(ball({0, 0, 0}, 1), ball({9, 0, 0}, 1))), std::set{beyond});
}

// A ball with a ball taken out of it.
Solid hollow_ball(double radius, double thickness) {
  return boolean(ball({0, 0, 0}, radius, 2), ball({0, 0, 0}, radius - thickness, 2),
                 Operation::subtract);
}

TEST(ClearRegions, WhatLiesInACavityIsNotBeyond) {
  const ClearRegions inside = regions(ball({0, 0, 0}, 0.5), hollow_ball(5, 1));
  ASSERT_EQ(all_of(inside).size(), 1u);
  EXPECT_NE(*all_of(inside).begin(), none);
  EXPECT_NE(*all_of(inside).begin(), beyond);
}

// The needle is one piece.
TEST(ClearRegions, WhatGoesThroughAHollowBallFallsIntoParts) {
  PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, 40, 400);
  for (Vec3& p : mesh.positions) p = {0.2 * p.x, 0.2 * p.y, 12 * p.z};
  const Solid needle = Solid::from_mesh(mesh);
  const ClearRegions found = regions(needle, hollow_ball(5, 1));
  std::map<std::uint32_t, std::set<bool>> is_outside;
  for (std::uint32_t s = 0; s < found.of_slot.size(); ++s)
    if (const Slot& slot = needle.data()->slot(s); found.of_slot[s] != none) {
      const Box& box = slot.block->bounds();
      is_outside[found.of_slot[s]].insert(std::abs(box.low[2] + box.high[2]) > 10);
    }
  EXPECT_GE(is_outside.size(), 2u);
  for (const auto& [region, sides] : is_outside) EXPECT_EQ(sides.size(), 1u);
  EXPECT_EQ(is_outside[beyond], std::set{true});
}

// The other one is a ball of nearly the same radius everywhere: who is in it says the distance.
TEST(ClearRegions, AllOfARegionIsOnOneSide) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  std::size_t clear = 0, near = 0;
  for (int i = 0; i < cases(60); ++i) {
    const Vec3 centre{anywhere(engine), anywhere(engine), anywhere(engine)};
    const double radius = 1 + 0.9 * anywhere(engine);
    const Solid a = ball({0, 0, 0}, 1), b = ball(centre, radius);
    const ClearRegions found = regions(a, b);
    std::map<std::uint32_t, std::set<bool>> inside;
    for (std::uint32_t s = 0; s < found.of_slot.size(); ++s) {
      const Slot& slot = a.data()->slot(s);
      if (slot.empty()) continue;
      const auto overlaps = [&](const Slot& t) {
        return !t.empty() && t.block->bounds().overlaps(slot.block->bounds());
      };
      const std::uint32_t region = found.of_slot[s];
      EXPECT_EQ(region == none, std::ranges::any_of(b.data()->slots(), overlaps));
      ++(region == none ? near : clear);
      if (region == none) continue;
      const Brep& brep = slot.block->brep();
      for (const VertexId v : brep.vertices()) {
        const Vec3& p = slot.block->geometry().position(brep.point_of(v));
        const double distance = std::hypot(p.x - centre.x, p.y - centre.y, p.z - centre.z);
        inside[region].insert(distance < 0.99 * radius);
        EXPECT_TRUE(distance < radius || distance > 0.99 * radius);
      }
    }
    for (const auto& [region, sides] : inside) {
      EXPECT_EQ(sides.size(), 1u);
      if (region == beyond) {
        EXPECT_EQ(sides, std::set{false});
      }
    }
  }
  EXPECT_GT(clear, near / 4);
}

// Two rings hang in each other like links of a chain, and nothing touches.
Solid ring(bool upright, double x) {
  PolygonMesh mesh;
  constexpr std::uint32_t around = 64, across = 16;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double far = 2 + 0.5 * std::cos(v);
      const Vec3 p{far * std::cos(u) + x, far * std::sin(u), 0.5 * std::sin(v)};
      mesh.positions.push_back(upright ? Vec3{p.x, -p.z, p.y} : p);
      const std::uint32_t next = (i + 1) % around * across, here = i * across,
                          beside = (j + 1) % across;
      mesh.indices.insert(mesh.indices.end(), {here + j, next + j, next + beside, here + j,
                                               next + beside, here + beside});
    }
  mesh.face_sizes.assign(mesh.indices.size() / 3, 3);
  return Solid::from_mesh(mesh);
}

TEST(ClearRegions, LinksOfAChainThatDoNotTouchAreApart) {
  const Solid a = ring(false, 0), b = ring(true, 2);
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  const Solid both = boolean(a, b, Operation::unite);
  EXPECT_EQ(both.counts().shells, 2u);
  EXPECT_EQ(both.counts().faces, a.counts().faces + b.counts().faces);
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == a);
}

TEST(ClearRegions, ABallWithinAThickShellIsWithin) {
  const Solid shell = hollow_ball(5, 4), within = hollow_ball(3, 1);
  EXPECT_TRUE(boolean(shell, within, Operation::intersect) == within);
  EXPECT_EQ(boolean(shell, within, Operation::subtract).counts().shells, 4u);
}

}  // namespace
}  // namespace sectile
