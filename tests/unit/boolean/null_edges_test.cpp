// The plan of the cuts, and the null edges that split the neighborhoods of their ends.
#include "boolean/null_edges/null_edges.h"

#include <gtest/gtest.h>

#include "sectile/transform.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

TEST(CutPlan, EachCutHasTwoEndsAndTwoOfThemMeetInEachCornerOfAHexagon) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  const CutPlan& plan = phases.plan();
  EXPECT_EQ(plan.ends.size(), 24u);
  EXPECT_EQ(plan.sites.size(), 12u);
  PerOperand<int> on_edges, within_faces;
  for (const SiteId s : plan.sites.ids()) {
    const Site& site = plan.sites[s];
    EXPECT_EQ(site.ends.size(), 2u);
    ++(site.entity.is_edge() ? on_edges : within_faces)[site.operand];
    for (const PlannedEndId end : site.ends) {
      EXPECT_EQ(plan.ends[end].site, s);
      EXPECT_EQ(plan.of_carrier[plan.ends[end].carrier][plan.ends[end].which], end);
    }
  }
  for (const Operand o : both_operands) {
    EXPECT_EQ(on_edges[o], 3);
    EXPECT_EQ(within_faces[o], 3);
  }
}

TEST(CutPlan, WhatIsNotCutHasNoEnds) {
  Phases phases(test::lower_cube(), test::flush_block(), Operation::subtract);
  EXPECT_TRUE(phases.plan().ends.empty());
  EXPECT_TRUE(phases.plan().sites.empty());
}

TEST(NullEdges, OneForEachCornerOfAHexagonAndOperand) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  phases.plan();
  PerOperand<std::size_t> vertices, edges;
  for (const Operand o : both_operands) {
    vertices[o] = phases.w.patch[o].brep.vertex_count();
    edges[o] = phases.w.patch[o].brep.edge_count();
  }
  const Cuts& cuts = phases.cuts();
  check_links(phases.w, "null edges");
  EXPECT_EQ(cuts.null_edges.size(), 12u);
  for (const NullEdge& e : cuts.null_edges)
    EXPECT_TRUE(phases.w.patch[e.operand].is_null(Brep::half_edge(e.edge)));
  // On an edge, one vertex divides it and one more is split off; within a face there are two.
  for (const Operand o : both_operands) {
    EXPECT_EQ(phases.w.patch[o].brep.vertex_count(), vertices[o] + 3 * 2 + 3 * 2);
    EXPECT_EQ(phases.w.patch[o].brep.edge_count(), edges[o] + 3 * 2 + 3);
    EXPECT_TRUE(cuts.bridged[o].empty());
  }
}

TEST(NullEdges, EachCutIsAttachedToTheChainOfItsSite) {
  Phases phases(test::lower_cube(), test::upper_cube(), Operation::intersect);
  const Cuts& cuts = phases.cuts();
  const Contacts& contacts = phases.contacts();
  for (const SiteId s : cuts.sites.ids()) {
    ASSERT_EQ(cuts.sites[s].ends.size(), 2u);
    for (const CutEndId id : cuts.sites[s].ends) {
      const CutEnd& end = cuts.ends[id];
      EXPECT_EQ(end.site, s);
      EXPECT_EQ(cuts.of_carrier[end.carrier][end.which], id);
      const Patch& patch = phases.w.patch[cuts.sites[s].operand];
      ASSERT_TRUE(end.first.valid() && end.last.valid());
      EXPECT_TRUE(patch.is_null(end.first));
      EXPECT_EQ(patch.brep.point_of(patch.brep.from(end.first)),
                contacts.point(cuts.sites[s].place));
    }
  }
}

// Two pyramids with one apex, turned by half a step: each of the four faces there is entered twice.
TEST(NullEdges, AnApexWithEightCutsBecomesEightVerticesInAChain) {
  const Solid a = pyramid(2, 2, 4);
  const Solid b = transformed(a, Transform::rotation_degrees({0, 0, 1}, 45));
  Phases phases(a, b, Operation::unite);
  const Cuts& cuts = phases.cuts();
  PerOperand<PointId> apex;
  for (const SplitSite& site : cuts.sites) {
    if (phases.position(site.place) != Vec3{0, 0, 2}) continue;
    EXPECT_TRUE(site.entity.is_vertex());
    EXPECT_EQ(site.ends.size(), 8u);
    apex[site.operand] = phases.contacts().point(site.place);
  }
  PerOperand<int> null_edges;
  for (const NullEdge& e : cuts.null_edges) {
    const Brep& brep = phases.w.patch[e.operand].brep;
    null_edges[e.operand] += brep.point_of(brep.from(Brep::half_edge(e.edge))) == apex[e.operand];
  }
  for (const Operand o : both_operands) EXPECT_EQ(null_edges[o], 7);
}

TEST(NullEdges, PyramidsThatTouchInTheirApexesNeedNone) {
  const Solid a = pyramid(2, 2, 4);
  const Solid b =
      transformed(a, Transform::translation({0, 0, 4}) * Transform::scaling({1, 1, -1}));
  Phases phases(a, b, Operation::unite);
  EXPECT_EQ(phases.contacts().contacts.size(), 1u);
  EXPECT_TRUE(phases.cuts().null_edges.empty());
}

}  // namespace
}  // namespace sectile
