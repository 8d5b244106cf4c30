// What the reduction gives for small solids: contacts, places, and segments between them.
#include "boolean/reduction/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "parallel/alone.h"
#include "sectile/transform.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

std::set<std::array<double, 3>> positions(Phases& phases) {
  std::set<std::array<double, 3>> found;
  for (const PlaceId place : phases.contacts().places.ids()) {
    const Vec3 p = phases.position(place);
    found.insert({p.x, p.y, p.z});
  }
  return found;
}

std::set<std::pair<PlaceId, PlaceId>> spans(const Contacts& contacts) {
  std::set<std::pair<PlaceId, PlaceId>> found;
  for (const SegmentRecord& r : contacts.segments) found.insert({r.place[0], r.place[1]});
  return found;
}

TEST(Reduction, CubesThatOverlapInACornerMeetInAHexagon) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  const Contacts& contacts = phases.contacts();
  EXPECT_EQ(positions(phases),
            (std::set<std::array<double, 3>>{
                {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {2, 2, 1}, {2, 1, 2}, {1, 2, 2}}));
  EXPECT_EQ(contacts.places.size(), 6u);
  PerOperand<int> edges;
  for (const Contact& c : contacts.contacts)
    for (const Operand s : both_operands)
      if (c.on[s].is_edge() && c.on[other(s)].is_face()) ++edges[s];
  EXPECT_EQ(contacts.contacts.size(), 6u);
  EXPECT_EQ(edges[Operand::a], 3);
  EXPECT_EQ(edges[Operand::b], 3);
  // Each side of the hexagon lies in one face of each cube.
  EXPECT_EQ(contacts.segments.size(), 6u);
  EXPECT_EQ(spans(contacts).size(), 6u);
  for (const SegmentRecord& r : contacts.segments) {
    EXPECT_LT(r.place[0], r.place[1]);
    for (const Operand s : both_operands) EXPECT_TRUE(r.on[s].is_face());
  }
}

// One of the six axes.
Vec3 outward_normal(const Workspace& w, Operand s, Entity face) {
  const PlaneId plane = w.patch[s].plane(face.face());
  const auto along = [&](int axis) { return double(w.tests().normal(plane, axis)); };
  return {along(0), along(1), along(2)};
}

TEST(Reduction, SegmentsOfTwoFacesKnowWhichWayTheCrossProductOfTheNormalsPoints) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  ASSERT_EQ(phases.contacts().segments.size(), 6u);
  for (const SegmentRecord& r : phases.contacts().segments) {
    const Vec3 a = outward_normal(phases.w, Operand::a, r.on[Operand::a]),
               b = outward_normal(phases.w, Operand::b, r.on[Operand::b]),
               from = phases.position(r.place[0]), to = phases.position(r.place[1]);
    const double along = (a.y * b.z - a.z * b.y) * (to.x - from.x) +
                         (a.z * b.x - a.x * b.z) * (to.y - from.y) +
                         (a.x * b.y - a.y * b.x) * (to.z - from.z);
    EXPECT_EQ(r.sense, sign_of(along));
  }
}

// A slab on which triangular prisms stand on an edge: the slab's face does not know of these edges.
Solid prisms_on_their_edges(int count) {
  Solid all = block({0, 0, -1}, {double(count), 3, 0});
  for (int i = 0; i < count; ++i) {
    const double x = i + 0.5;
    const PolygonMesh prism{{{x, 1, 0},
                             {x - 0.25, 1, 1},
                             {x + 0.25, 1, 1},
                             {x, 2, 0},
                             {x - 0.25, 2, 1},
                             {x + 0.25, 2, 1}},
                            {3, 3, 4, 4, 4},
                            {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5}};
    all = boolean(all, Solid::from_mesh(prism), Operation::unite);
  }
  return all;
}

// Is a place strictly between the ends of a segment along the x axis?
bool is_within(const Vec3& at, Vec3 from, Vec3 to) {
  if (from.x > to.x) std::swap(from, to);
  return from.y == to.y && from.z == to.z && at.y == from.y && at.z == from.z && from.x < at.x &&
         at.x < to.x;
}

TEST(Reduction, SegmentsEndWhereAnEdgeOfTheSameOperandTouchesTheirFace) {
  constexpr int count = 12;
  Solid blocks;
  for (int i = 0; i < count; ++i)
    blocks = boolean(blocks, block({i + 0.25, 1.5, -0.5}, {i + 0.75, 5, 0.5}), Operation::unite);
  Phases phases(prisms_on_their_edges(count), blocks, Operation::intersect);
  const Contacts& contacts = phases.contacts();
  ASSERT_GT(contacts.places.size() * contacts.segments.size(), 10000u);
  int ends_at_edge = 0;
  for (const SegmentRecord& r : contacts.segments) {
    const Vec3 from = phases.position(r.place[0]), to = phases.position(r.place[1]);
    for (const PlaceId place : contacts.places.ids())
      EXPECT_FALSE(is_within(phases.position(place), from, to));
    for (const Vec3& end : {from, to})
      ends_at_edge += from.z == 0 && to.z == 0 && end.y == 1.5 && end.x - std::floor(end.x) == 0.5;
  }
  EXPECT_EQ(ends_at_edge, 2 * count);  // in the slab's face, on both sides of each edge
}

TEST(Reduction, FlushBlocksMeetInTheEdgesOfTheirCommonFace) {
  Phases phases(test::lower_cube(), test::flush_block(), Operation::unite);
  const Contacts& contacts = phases.contacts();
  EXPECT_EQ(positions(phases),
            (std::set<std::array<double, 3>>{{2, 0, 0}, {2, 2, 0}, {2, 0, 2}, {2, 2, 2}}));
  for (const Contact& c : contacts.contacts)
    for (const Operand s : both_operands) EXPECT_TRUE(c.on[s].is_vertex());
  EXPECT_EQ(spans(contacts).size(), 4u);
  for (const SegmentRecord& r : contacts.segments)
    for (const Operand s : both_operands) {
      EXPECT_TRUE(r.on[s].is_edge());
      for (const Entity& end : r.end[s]) EXPECT_TRUE(end.is_vertex());
    }
  // Vertices at one place share one point from here on.
  for (const Contact& c : contacts.contacts)
    for (const Operand s : both_operands)
      EXPECT_EQ(phases.w.patch[s].brep.point_of(c.on[s].vertex()), contacts.point(c.place));
}

TEST(Reduction, BlocksThatTouchInAPointHaveOnePlaceAndNoSegment) {
  Phases phases(test::lower_cube(), block({2, 2, 2}, {3, 3, 3}), Operation::unite);
  EXPECT_EQ(positions(phases), (std::set<std::array<double, 3>>{{2, 2, 2}}));
  EXPECT_EQ(phases.contacts().contacts.size(), 1u);
  EXPECT_TRUE(phases.contacts().segments.empty());
}

TEST(Reduction, BlocksApartHaveNoContact) {
  Phases phases(test::lower_cube(), block({5, 0, 0}, {6, 1, 1}), Operation::unite);
  EXPECT_TRUE(phases.contacts().contacts.empty());
  EXPECT_TRUE(phases.contacts().places.empty());
  EXPECT_TRUE(phases.contacts().segments.empty());
}

// In builds in which even few are a crowd, all threads have work.
TEST(Loading, WhereLittleIsNearOtherThreadsAreNotWoken) {
  {
    const Phases few(test::lower_cube(), test::upper_cube(), Operation::unite);
    EXPECT_EQ(parallel::Alone::now(), threshold(true, false));
  }
  EXPECT_FALSE(parallel::Alone::now());
  const Solid ball = sphere(1, 90, 60);
  const Phases many(ball, transformed(ball, Transform::translation({0.5, 0, 0})), Operation::unite);
  EXPECT_FALSE(parallel::Alone::now());
}

}  // namespace
}  // namespace sectile
