#include "storage/touching_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "sectile/sectile.h"

namespace sectile {
namespace {

using Tetrahedron = std::array<Vec3, 4>;

// Do the last three, as seen from the first?
bool turns_left(const Tetrahedron& t) {
  const auto way = [&](std::size_t i) {
    return Vec3{t[i].x - t[0].x, t[i].y - t[0].y, t[i].z - t[0].z};
  };
  const Vec3 a = way(1), b = way(2), c = way(3);
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x) <
         0;
}

PolygonMesh mesh_of(std::initializer_list<Tetrahedron> tetrahedra) {
  PolygonMesh mesh;
  for (Tetrahedron t : tetrahedra) {
    if (turns_left(t)) std::swap(t[2], t[3]);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), t.begin(), t.end());
    for (const std::array<std::uint32_t, 3>& f :
         {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {0u, 3u, 2u}, {1u, 2u, 3u}}) {
      mesh.face_sizes.push_back(3);
      for (const std::uint32_t v : f) mesh.indices.push_back(first + v);
    }
  }
  return mesh;
}
bool may_touch_in_lines(std::initializer_list<Tetrahedron> tetrahedra) {
  return may_touch_in_lines(*Solid::from_mesh(mesh_of(tetrahedra)).data());
}

constexpr Tetrahedron corner{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}};

TEST(TouchingLines, ASolidThatTouchesItselfNowhereHasNone) {
  EXPECT_FALSE(may_touch_in_lines({corner}));
}

TEST(TouchingLines, SolidsThatTouchInAVertexHaveNone) {
  EXPECT_FALSE(
      may_touch_in_lines({corner, {{{0, 0, 0}, {-4, -1, -1}, {-1, -1, -4}, {-1, -4, -1}}}}));
}

TEST(TouchingLines, AnEdgeThatGoesOnBeyondTheVertexIsNoLine) {
  EXPECT_FALSE(may_touch_in_lines({corner, {{{0, 0, 0}, {-4, 0, 0}, {-1, -1, -4}, {-1, -4, -1}}}}));
}

TEST(TouchingLines, SolidsThatTouchInAnEdgeHaveOne) {
  EXPECT_TRUE(may_touch_in_lines({corner, {{{0, 0, 0}, {4, 0, 0}, {0, -1, -4}, {0, -4, -1}}}}));
}

TEST(TouchingLines, EdgesOfTwoLengthsHaveOne) {
  EXPECT_TRUE(may_touch_in_lines({corner, {{{0, 0, 0}, {2, 0, 0}, {0, -1, -4}, {0, -4, -1}}}}));
}

TEST(TouchingLines, AnEdgeInAFaceIsOne) {
  EXPECT_TRUE(may_touch_in_lines({corner, {{{0, 0, 0}, {1, 1, 0}, {-1, 0, -4}, {0, -1, -4}}}}));
}

// What is not known exactly may be anything.
TEST(TouchingLines, VerticesThatAreNotGivenMayHaveSome) {
  const Solid two =
      Solid::from_mesh(mesh_of({corner, {{{0, 0, 0}, {-4, -1, -1}, {-1, -1, -4}, {-1, -4, -1}}}}));
  EXPECT_FALSE(may_touch_in_lines(*two.data()));
  EXPECT_TRUE(
      may_touch_in_lines(*transformed(two, Transform::rotation_degrees({1, 2, 3}, 40)).data()));
}

// Blocks have numbers of their own for a vertex, and several if what they have around it does not
// hang together.
TEST(TouchingLines, AVertexInSeveralBlocksIsOne) {
  PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, 120, 91);
  for (Vec3& p : mesh.positions) {  // flat in many places, which become one face each
    const auto step = [](double v) { return std::round(v * 16) / 16; };
    if (std::abs(p.x) + std::abs(p.y) < 0.9) p.z = p.z > 0 ? step(0.8) : step(-0.8);
  }
  const Solid solid = Solid::from_mesh(mesh);
  ASSERT_GT(solid.data()->slots().size(), 1u);
  EXPECT_FALSE(may_touch_in_lines(*solid.data()));
}

TEST(TouchingLines, WhatTouchesInVerticesOnlyIsTakenAwayAsItIs) {
  const Solid two =
      Solid::from_mesh(mesh_of({corner, {{{0, 0, 0}, {-4, -1, -1}, {-1, -1, -4}, {-1, -4, -1}}}}));
  const Solid around = block({-9, -9, -9}, {9, 9, 9});
  const Solid mould = boolean(around, two, Operation::subtract);
  EXPECT_TRUE(validate(mould).empty());
  EXPECT_EQ(mould.volume(), around.volume() - two.volume());
  EXPECT_EQ(boolean(around, mould, Operation::subtract), two);
}

}  // namespace
}  // namespace sectile
