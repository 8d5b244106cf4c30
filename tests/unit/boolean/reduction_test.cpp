// What the reduction gives for small solids: contacts, places, and segments between them.
#include "boolean/reduction/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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

}  // namespace
}  // namespace sectile
