// What lies around the segments of small solids, its classes, and the wedges of material.
#include "boolean/neighborhoods/neighborhoods.h"

#include <gtest/gtest.h>

#include "search/approximate.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using namespace approximate;
using test::Phases;

std::size_t cut_carriers(const Neighborhoods& n) {
  std::size_t count = 0;
  for (const Carrier& c : n.carriers) count += c.cut;
  return count;
}

TEST(Neighborhoods, TwoFacesThatCrossAreFourHalfPlanesInTurn) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    Phases phases(test::lower_cube(), test::upper_cube(), operation);
    const Neighborhoods& n = phases.neighborhoods();
    ASSERT_EQ(n.segments.size(), 6u);
    for (const Segment& s : n.segments) {
      ASSERT_EQ(s.carriers.size(), 2u);
      ASSERT_EQ(s.half_planes.size(), 4u);
      EXPECT_TRUE(s.plane[1].valid());
      PerOperand<int> in, out;
      for (std::size_t i = 0; i < 4; ++i) {
        const HalfPlane& h = n.half_planes[s.half_planes[i]];
        EXPECT_NE(h.operand, n.half_planes[s.half_planes[(i + 1) % 4]].operand);
        EXPECT_EQ(n.carriers[h.carrier].operand, h.operand);
        EXPECT_EQ(n.carriers[h.carrier].entity, Entity(h.face));
        ++(h.cls == Class::in ? in : out)[h.operand];
        EXPECT_TRUE(h.cls == Class::in || h.cls == Class::out);
      }
      for (const Operand o : both_operands) {
        EXPECT_EQ(in[o], 1);
        EXPECT_EQ(out[o], 1);
      }
    }
    // One wedge of material each, between two faces, so that all are cut.
    ASSERT_EQ(n.wedges.size(), 1u);
    EXPECT_EQ(n.wedges[0].pairs.size(), 6u);
    for (const WedgePair& pair : n.wedges[0].pairs)
      for (const HalfPlaneId id : {pair.first, pair.second}) {
        const HalfPlane& h = n.half_planes[id];
        const bool outside = operation == Operation::unite ||
                             (operation == Operation::subtract && h.operand == Operand::a);
        EXPECT_EQ(h.cls, outside ? Class::out : Class::in);
      }
    EXPECT_EQ(cut_carriers(n), 12u);
  }
}

TEST(Neighborhoods, AFaceIsCutInTheDirectionFromTheFirstPlaceToTheSecond) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  const Neighborhoods& n = phases.neighborhoods();
  const auto normal = [&](PlaneId s) {
    const PlaneValue& value = phases.w.tests().value(s);
    return Vec3{value.n[0], value.n[1], value.n[2]};
  };
  for (const Segment& s : n.segments)
    for (const CarrierId id : s.carriers) {
      const Carrier& c = n.carriers[id];
      ASSERT_TRUE(c.cut && c.entity.is_face());
      const Vec3 across = normal(c.direction.across),
                 way = phases.position(s.place[1]) - phases.position(s.place[0]);
      EXPECT_EQ(dot(across, way), 0);
      const PlaneId plane = phases.w.patch[c.operand].plane(c.entity.face());
      EXPECT_EQ(sign_of(dot(cross(normal(plane), across), way)), c.direction.sense);
    }
}

TEST(Neighborhoods, AroundTheEdgesOfFlushBlocks) {
  const auto run = [](Operation operation, std::size_t wedges, std::size_t cut) {
    Phases phases(test::lower_cube(), test::flush_block(), operation);
    const Neighborhoods& n = phases.neighborhoods();
    ASSERT_EQ(n.segments.size(), 4u);
    for (const Segment& s : n.segments) {
      EXPECT_EQ(s.carriers.size(), 2u);
      ASSERT_EQ(s.half_planes.size(), 4u);
      int opposite = 0, outside = 0;
      for (const HalfPlaneId id : s.half_planes) {
        opposite += n.half_planes[id].cls == Class::on_minus;
        outside += n.half_planes[id].cls == Class::out;
      }
      EXPECT_EQ(opposite, 2);  // the two copies of the common face
      EXPECT_EQ(outside, 2);
    }
    EXPECT_EQ(n.wedges[0].pairs.size(), wedges);
    EXPECT_EQ(cut_carriers(n), cut);
  };
  // The union is one wedge between faces of both; A \ B is A with the wedge that it had; A ∩ B is
  // empty.
  run(Operation::unite, 4, 8);
  run(Operation::subtract, 4, 0);
  run(Operation::intersect, 0, 0);
}

TEST(Neighborhoods, WithoutAnOperationItIsCutWhereTheClassChanges) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  const Neighborhoods n = find_neighborhoods(phases.w, phases.contacts(), {});
  EXPECT_TRUE(n.wedges.empty());
  EXPECT_EQ(cut_carriers(n), 12u);
}

}  // namespace
}  // namespace sectile
