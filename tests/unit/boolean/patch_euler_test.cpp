// What is known of a patch's edges and faces grows with its structure.
#include "boolean/patch_euler.h"

#include <gtest/gtest.h>

#include "sectile/primitives.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

// Two blocks that are flush: the seams between their faces are flat.
Solid block_with_seams() {
  return boolean(test::lower_cube(), test::flush_block(), Operation::unite);
}

void expect_complete(const Patch& patch) {
  EXPECT_EQ(patch.side_plane.size(), patch.brep.half_edge_count());
  EXPECT_EQ(patch.root.size(), patch.brep.face_count());
  // What only loaded edges are asked for does not.
  EXPECT_EQ(patch.flat.size(), patch.loaded_edges);
}

TEST(PatchEuler, BothPartsOfAnEdgeLieInThePlanesOfTheWhole) {
  test::Phases phases(block_with_seams(), test::upper_cube(), Operation::unite);
  Patch& patch = phases.w.patch[Operand::a];
  std::size_t flat = 0;
  const IdRange<EdgeId> edges(EdgeId(0), EdgeId(patch.brep.edge_count()));
  for (const EdgeId e : edges) {
    const HalfEdgeId h = Brep::half_edge(e);
    const HalfEdgeId on = PatchEuler(patch).divide(h, phases.w.geometry.add_point(Vec3{0, 0, 0}));
    EXPECT_EQ(patch.brep.next_of(h), on);
    EXPECT_EQ(patch.side(on), patch.side(h));
    EXPECT_EQ(patch.side(Brep::twin(on)), patch.side(Brep::twin(h)));
    flat += patch.is_flat(e);
  }
  EXPECT_GE(flat, 2u);
  expect_complete(patch);
}

TEST(PatchEuler, AFaceThatIsMadeIsAPartOfTheSameLoadedFace) {
  test::Phases phases(test::lower_cube(), test::upper_cube(), Operation::unite);
  Patch& patch = phases.w.patch[Operand::a];
  const Brep& brep = patch.brep;
  const FaceId face(2);
  const HalfEdgeId a = brep.loop_half_edge[brep.outer_loop[face]],
                   b = brep.next_of(brep.next_of(a));
  const PlaneId across(0);
  const HalfEdgeId made = PatchEuler(patch).mef(a, b, Euler::NewFace::left, across);
  expect_complete(patch);
  for (const HalfEdgeId h : {made, Brep::twin(made)}) {
    EXPECT_EQ(patch.root_of(h), face);
    EXPECT_EQ(patch.side(h), across);
  }
}

}  // namespace
}  // namespace sectile
