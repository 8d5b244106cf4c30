// Some faces of solids in several blocks, loaded into a patch.
#include <gtest/gtest.h>

#include <set>

#include "boolean/patch.h"
#include "geometry/kernel.h"
#include "geometry/loop_area.h"
#include "sectile/sectile.h"
#include "topology/links.h"
#include "unit/boolean/some_faces.h"

namespace sectile {
namespace {

// The blocks around the dent are turned.
Solid ball_with_a_dent() {
  const Solid ball = sphere(1, 90, 60);
  return boolean(ball, transformed(ball, Transform::translation({0.7, 0.5, 0.3})),
                 Operation::subtract);
}

std::vector<Vec3> corners_in_solid(const SolidData& solid, FaceId face) {
  const Slot& slot = solid.slot(solid.slot_of(face));
  const Brep& brep = slot.block->brep();
  std::vector<Vec3> corners;
  for (LoopId l = brep.outer_loop[solid.local(solid.slot_of(face), face)]; l.valid();
       l = brep.next_loop[l])
    for_each_in_loop(slot, l, [&](HalfEdgeId h) {
      corners.push_back(slot.block->geometry().position(slot.start_of(h)));
    });
  return corners;
}

class LoadedPart : public testing::TestWithParam<double> {
 protected:
  const Solid solid_ = ball_with_a_dent();
  const SolidData& data_ = *solid_.data();
  const std::vector<FaceId> faces_ = test::some_faces(data_, GetParam());
  Geometry geometry_;
  const Patch patch_ = load_patch(data_, faces_, geometry_);
  const Kernel kernel_{geometry_};

  std::vector<PointId> corners(FaceId loaded) const {
    std::vector<PointId> points;
    for_each_in_face(patch_.brep, loaded, [&](HalfEdgeId h) {
      points.push_back(patch_.brep.point_of(patch_.brep.from(h)));
    });
    return points;
  }
};

TEST_P(LoadedPart, IsAClosedStructureOfBlocksOfBothSenses) {
  bool turned = false, straight = false;
  for (const FaceId f : faces_) (data_.slot(data_.slot_of(f)).turned ? turned : straight) = true;
  EXPECT_TRUE(turned && straight);
  EXPECT_EQ(patch_.face_in_solid, faces_);
  EXPECT_EQ(broken_links(patch_.brep, false), std::vector<std::string>{});
}

TEST_P(LoadedPart, HasTheSolidsFaces) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const std::vector<PointId> points = corners(FaceId(i));
    std::vector<Vec3> positions;
    for (const PointId p : points) positions.push_back(geometry_.position(p));
    ASSERT_EQ(positions, corners_in_solid(data_, faces_[i]));
    ASSERT_TRUE(is_counter_clockwise(kernel_, patch_.plane(FaceId(i)), points));
    for (const PointId p : points) ASSERT_EQ(kernel_.side(p, patch_.plane(FaceId(i))), Sign::zero);
  }
}

TEST_P(LoadedPart, HasEachEdgeOnceAndKnowsWhatIsBeyond) {
  const std::set<EdgeId> once(patch_.edge_in_solid.begin(), patch_.edge_in_solid.end());
  EXPECT_EQ(once.size(), patch_.brep.edge_count());
  const std::set<FaceId> loaded(faces_.begin(), faces_.end());
  for (const HalfEdgeId h : patch_.brep.half_edges()) {
    const HalfEdgeId beyond = patch_.half_edge_in_solid[h];
    ASSERT_EQ(beyond.valid(), !patch_.is_real(patch_.brep.face_of(h)));
    if (!beyond.valid()) continue;
    const std::uint32_t s = data_.slot_of(beyond);
    const Brep& brep = data_.slot(s).block->brep();
    ASSERT_FALSE(loaded.contains(data_.face(s, brep.face_of(data_.local(s, beyond)))));
    const PlaneId plane = patch_.side(Brep::twin(h));
    for (const VertexId v : {patch_.brep.from(h), patch_.brep.to(h)})
      ASSERT_EQ(kernel_.side(patch_.brep.point_of(v), plane), Sign::zero);
  }
}

INSTANTIATE_TEST_SUITE_P(Shares, LoadedPart, testing::Values(0.01, 0.2, 0.8, 1.0));

}  // namespace
}  // namespace sectile
