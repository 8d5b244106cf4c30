#include "storage/touching_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
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
bool may_touch_in_lines(const Solid& solid) {
  return !slots_touching_in_lines(*solid.data()).empty();
}
bool may_touch_in_lines(std::initializer_list<Tetrahedron> tetrahedra) {
  return may_touch_in_lines(Solid::from_mesh(mesh_of(tetrahedra)));
}

// A pyramid upside down; of the squares of its base, those of every other field have heights of
// their own, and the others are flat.
PolygonMesh rough_checkers(std::uint32_t n) {
  PolygonMesh mesh;
  std::mt19937 random(1);
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const bool flat = i % n == 0 || j % n == 0 || (i / 3 + j / 3) % 2 == 0;
      mesh.positions.push_back({double(i), double(j), flat ? 1 : 1 + random() % 1000 / 1000.0});
    }
  const auto apex = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back({n / 2.0, n / 2.0, -5});
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
    add(at(i + 1, 0), at(i, 0), apex);
    add(at(n, i + 1), at(n, i), apex);
    add(at(i, n), at(i + 1, n), apex);
    add(at(0, i), at(0, i + 1), apex);
  }
  return mesh;
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
  EXPECT_FALSE(may_touch_in_lines(two));
  EXPECT_TRUE(may_touch_in_lines(transformed(two, Transform::rotation_degrees({1, 2, 3}, 40))));
}

// Blocks have numbers of their own for a vertex, and several if what they have around it does not
// hang together.
TEST(TouchingLines, AVertexInSeveralBlocksIsOne) {
  const Solid solid = Solid::from_mesh(rough_checkers(140));
  ASSERT_FALSE(solid.data()->touching_slots().empty());  // they are marked for it
  EXPECT_FALSE(may_touch_in_lines(solid));
}

// Vertices of results are no doubles, but have places of their own as well.
TEST(TouchingLines, AVertexOfAResultInSeveralBlocksIsOne) {
  const Solid rough = Solid::from_mesh(rough_checkers(140));
  const Transform turned = Transform::translation({70, 70, 0}) *
                           Transform::rotation_degrees({0, 0, 1}, 40) *
                           Transform::translation({-70, -70, 0});
  const Solid both = boolean(rough, transformed(rough, turned), Operation::unite);
  ASSERT_FALSE(both.data()->touching_slots().empty());
  EXPECT_FALSE(may_touch_in_lines(both));
}

// Two tetrahedra with an edge in common, of which slanted planes leave the middle.
Solid tetrahedra_along_an_edge_without_its_ends() {
  const Solid two = Solid::from_mesh(mesh_of({{{{0, 0, 0}, {0, 0, 7}, {5, 1, 0}, {4, -2, 1}}},
                                              {{{0, 0, 0}, {0, 0, 7}, {-5, 1, 2}, {-4, -2, 1}}}}));
  const Solid below = split(two, {1, 2, 3, -16}).second;
  return split(below, {-1, 1, 3, -4}).first;
}

TEST(TouchingLines, OfResultsAreFoundWhereTheyEndInVerticesThatAreNoDoubles) {
  const Solid two = tetrahedra_along_an_edge_without_its_ends();
  EXPECT_TRUE(may_touch_in_lines(two));
  const Solid around = block({-9, -9, -9}, {9, 9, 9});
  const Solid mould = boolean(around, two, Operation::subtract);
  EXPECT_TRUE(validate(mould).empty());
  EXPECT_NEAR(mould.volume(), around.volume() - two.volume(), 1e-9);
  EXPECT_EQ(boolean(around, mould, Operation::subtract), two);
}

TEST(TouchingLines, AreLookedForAroundThePlacesOnlyFromWhichTheyMayLead) {
  const Solid rough = Solid::from_mesh(rough_checkers(140));
  const Solid beside =
      transformed(tetrahedra_along_an_edge_without_its_ends(), Transform::translation({-20, 0, 0}));
  const Solid both = boolean(rough, beside, Operation::unite);
  const auto slots = slots_touching_in_lines(*both.data());
  EXPECT_FALSE(slots.empty());
  EXPECT_LT(slots.size(), both.data()->touching_slots().size());
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
