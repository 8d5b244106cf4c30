// Blocks of a large import are triangles until somebody asks for their structure.
#include <gtest/gtest.h>

#include "sectile/rounding.h"
#include "sectile/sectile.h"
#include "storage/solid_data.h"
#include "topology/links.h"
#include "unit/large_meshes.h"

namespace sectile {
namespace {

Solid large_ball() {
  return Solid::from_mesh(tube(120, 150, true, on_ball));
}

Solid tool_at_its_side() {
  return transformed(sphere(0.05, 12, 9), Transform::translation({1, 0, 0}));
}

// What share of its blocks has a structure. Those of which faces lie in one plane have one.
double share_with_structure(const Solid& solid) {
  double blocks = 0, made = 0;
  for (const Slot& slot : solid.data()->slots()) {
    if (slot.empty()) continue;
    ++blocks;
    if (slot.block->has_structure()) ++made;
  }
  return made / blocks;
}

TEST(LateBlocks, AnImportHasNextToNoStructure) {
  const Solid ball = large_ball();
  EXPECT_GT(ball.data()->slots().size(), 100u);
  EXPECT_LT(share_with_structure(ball), 0.05);
}

TEST(LateBlocks, ACutMakesThoseAtTheCutOnly) {
  const Solid ball = large_ball(), tool = tool_at_its_side();
  for (const Operation operation : {Operation::unite, Operation::subtract}) {
    const Solid result = boolean(ball, tool, operation);
    EXPECT_LT(share_with_structure(ball), 0.1);
    EXPECT_LT(share_with_structure(result), 0.1);
  }
}

TEST(LateBlocks, SoDoesACutInAnImageOfTheImport) {
  const Transform turn = Transform::rotation_degrees({1, 2, 3}, 40);
  const Solid ball = large_ball(), tool = tool_at_its_side();
  const Solid cut = boolean(transformed(ball, turn), transformed(tool, turn), Operation::subtract);
  EXPECT_LT(share_with_structure(ball), 0.1);
  EXPECT_LT(share_with_structure(cut), 0.1);
  EXPECT_EQ(cut, transformed(boolean(large_ball(), tool, Operation::subtract), turn));
}

std::vector<FaceSource> sources_of(const Solid& solid) {
  std::vector<FaceSource> sources;
  for (const Slot& slot : solid.data()->slots())
    if (!slot.empty())
      slot.block->for_each_source([&](const FaceSource& from) { sources.push_back(from); });
  return sources;
}

TEST(LateBlocks, TellWhatTheirFacesComeFromWithoutAStructure) {
  const Solid ball = large_ball();
  const std::vector<FaceSource> told = sources_of(ball);
  EXPECT_LT(share_with_structure(ball), 0.05);
  std::vector<FaceSource> made;
  for (const Slot& slot : ball.data()->slots())
    if (!slot.empty())
      made.insert(made.end(), slot.block->brep().source.begin(), slot.block->brep().source.end());
  EXPECT_EQ(told, made);
  EXPECT_EQ(sources_of(ball), made);
}

// What is looked into is what lies near the crossing.
TEST(LateBlocks, ARepairMakesThoseNearTheCrossingOnly) {
  PolygonMesh other = tube(120, 150, true, on_ball);
  for (Vec3& p : other.positions) p = {p.x + 0.41, p.y + 0.23, p.z + 0.17};
  const Solid united = repair(both(tube(120, 150, true, on_ball), other));
  EXPECT_LT(share_with_structure(united), 0.7);
  EXPECT_EQ(united.counts().shells, 1u);
}

TEST(LateBlocks, AreWrittenAsTheyCame) {
  const Solid ball = large_ball(), tool = tool_at_its_side();
  const Solid cut = boolean(ball, tool, Operation::subtract);
  EXPECT_EQ(cut.to_mesh().face_sizes.size(), rounded_mesh(cut).mesh.face_sizes.size());
  EXPECT_LT(share_with_structure(ball), 0.1);
  EXPECT_LT(share_with_structure(cut), 0.1);
}

TEST(LateBlocks, AreWrittenTheWayRoundThatTheyHave) {
  const Solid ball = large_ball(), box = block({-2, -2, -2}, {2, 2, 2});
  const Solid hollow = boolean(box, ball, Operation::subtract);
  const Solid mirrored = transformed(ball, Transform{{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}});
  for (const Solid& solid : {ball, hollow, mirrored}) {
    EXPECT_EQ(Solid::from_mesh(solid.to_mesh()), solid);
    EXPECT_EQ(Solid::from_mesh(rounded_mesh(solid).mesh), solid);
  }
}

TEST(LateBlocks, TheirStructureIsThatOfABoundary) {
  const Solid ball = large_ball();
  EXPECT_TRUE(broken_links(ball.data()->whole().brep(), false).empty());
  EXPECT_EQ(share_with_structure(ball), 1.0);
  EXPECT_TRUE(validate(ball).empty());
}

TEST(LateBlocks, HaveTheSizesOfTheirStructure) {
  const Solid ball = large_ball();
  for (const Slot& slot : ball.data()->slots()) {
    const Block& block = *slot.block;
    const std::size_t faces = block.face_count(), half_edges = block.half_edge_count(),
                      loops = block.loop_count(), vertices = block.vertex_count();
    const Brep& brep = block.brep();
    EXPECT_EQ(faces, brep.face_count());
    EXPECT_EQ(half_edges, brep.half_edge_count());
    EXPECT_EQ(loops, brep.loop_count());
    EXPECT_EQ(vertices, brep.vertex_count());
    const Pieces pieces(brep, block.border_count);
    ASSERT_EQ(block.pieces().count(), pieces.count());
    for (const FaceId f : brep.faces()) EXPECT_EQ(block.pieces().of(f), pieces.of(f));
  }
}

}  // namespace
}  // namespace sectile
