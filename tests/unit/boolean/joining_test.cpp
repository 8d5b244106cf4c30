// The sides of the cuts, and the parts into which they divide the faces.
#include "boolean/joining/joining.h"

#include <gtest/gtest.h>

#include <numeric>

#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

std::size_t faces_of_kind(const Patch& patch, FaceKind kind) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < patch.brep.face_count(); ++f)
    count += patch.brep.kind_of(FaceId(f)) == kind;
  return count;
}

TEST(Joining, AHexagonDividesThreeFacesOfEachCube) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  phases.contacts();
  PerOperand<std::size_t> before;
  for (const Operand o : both_operands)
    before[o] = faces_of_kind(phases.w.patch[o], FaceKind::real);
  const JoinedCuts& joined = phases.joined();
  check_links(phases.w, "joining");
  for (const Operand o : both_operands) {
    const auto& divided = joined.divided[o];
    EXPECT_EQ(std::accumulate(divided.begin(), divided.end(), 0), 3);
    EXPECT_EQ(faces_of_kind(phases.w.patch[o], FaceKind::real), before[o] + 3);
    EXPECT_EQ(faces_of_kind(phases.w.patch[o], FaceKind::null), 6u);
  }
}

TEST(Joining, TheSidesOfACutRunAlongItsSegmentOnRealFacesWithANullFaceBetween) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  const JoinedCuts& joined = phases.joined();
  const Neighborhoods& n = phases.neighborhoods();
  for (const Segment& segment : n.segments)
    for (const CarrierId id : segment.carriers) {
      ASSERT_TRUE(n.carriers[id].cut);
      const Patch& patch = phases.w.patch[n.carriers[id].operand];
      const Brep& brep = patch.brep;
      const auto [forward, backward] = joined.sides[id];
      const PointId from = phases.contacts().point(segment.place[0]),
                    to = phases.contacts().point(segment.place[1]);
      EXPECT_EQ(brep.point_of(brep.from(forward)), from);
      EXPECT_EQ(brep.point_of(brep.to(forward)), to);
      EXPECT_EQ(brep.point_of(brep.from(backward)), to);
      EXPECT_EQ(brep.point_of(brep.to(backward)), from);
      for (const HalfEdgeId h : {forward, backward}) {
        EXPECT_TRUE(patch.is_real(brep.face_of(h)));
        EXPECT_EQ(patch.root_of(h), n.carriers[id].entity.face());
        EXPECT_EQ(brep.kind_of(brep.face_of(Brep::twin(h))), FaceKind::null);
      }
      EXPECT_NE(brep.face_of(forward), brep.face_of(backward));
    }
}

// A bar through a plate: the plate's two large faces get a hole each, and the bar's faces fall into
// three parts each.
TEST(Joining, APartWithinAFaceIsAFaceOfItsOwnInAHole) {
  Phases phases(block({0, 0, 0}, {6, 6, 1}), block({2, 2, -1}, {4, 4, 2}), Operation::subtract);
  phases.joined();
  const Patch& plate = phases.w.patch[Operand::a];
  std::size_t with_hole = 0;
  for (const FaceId f : plate.brep.faces()) {
    if (!plate.is_real(f)) continue;
    std::size_t loops = 0;
    for (LoopId l = plate.brep.outer_loop[f]; l.valid(); l = plate.brep.next_loop[l])
      loops += plate.brep.loop_half_edge[l].valid();
    with_hole += loops == 2;
    EXPECT_LE(loops, 2u);
  }
  EXPECT_EQ(with_hole, 2u);
  const Patch& bar = phases.w.patch[Operand::b];
  PerOperand<std::size_t> parts;
  for (std::size_t f = 0; f < bar.brep.face_count(); ++f)
    if (bar.is_real(FaceId(f)) && phases.joined().divided[Operand::b][bar.root_of(FaceId(f))])
      ++parts[Operand::b];
  EXPECT_EQ(parts[Operand::b], 12u);
}

}  // namespace
}  // namespace sectile
