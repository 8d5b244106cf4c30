// Which faces stay, and how labels reach what no contact touches.
#include "boolean/components/components.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boolean/components/point_in_solid.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

// How many faces stay of an operand, loaded or not.
std::size_t kept_faces(Phases& phases, Operand o) {
  const FaceLabels& kept = phases.kept();
  const auto& loaded = kept.loaded[o];
  auto count = static_cast<std::size_t>(std::count(loaded.begin(), loaded.end(), 1));
  const Patch& patch = phases.w.patch[o];
  if (kept.rest[o].empty()) return count;
  for (std::size_t f = 0; f < patch.solid->face_count(); ++f)
    count += kept.rest[o].label(0, FaceId(f)) == 1;
  return count;
}

void expect_kept(const Solid& a, const Solid& b, Operation operation, std::size_t of_a,
                 std::size_t of_b) {
  Phases phases(a, b, operation);
  EXPECT_EQ(kept_faces(phases, Operand::a), of_a);
  EXPECT_EQ(kept_faces(phases, Operand::b), of_b);
}

TEST(Components, OfCubesThatOverlapInACorner) {
  const Solid a = test::lower_cube(), b = test::upper_cube();
  expect_kept(a, b, Operation::unite, 6, 6);
  expect_kept(a, b, Operation::intersect, 3, 3);
  expect_kept(a, b, Operation::subtract, 6, 3);
}

TEST(Components, OfFlushBlocks) {
  const Solid a = test::lower_cube(), b = test::flush_block();
  expect_kept(a, b, Operation::unite, 5, 5);
  expect_kept(a, b, Operation::intersect, 0, 0);
  expect_kept(a, b, Operation::subtract, 6, 0);
}

TEST(Components, AShellWithoutContactTakesARay) {
  const Solid a = block({0, 0, 0}, {9, 9, 9}), inside = block({2, 2, 2}, {3, 3, 3}),
              outside = block({10, 0, 0}, {11, 1, 1});
  expect_kept(a, inside, Operation::unite, 6, 0);
  expect_kept(a, inside, Operation::subtract, 6, 6);
  expect_kept(a, inside, Operation::intersect, 0, 6);
  expect_kept(a, outside, Operation::unite, 6, 6);
  expect_kept(a, outside, Operation::intersect, 0, 0);
}

// Each corner of the tetrahedron lies within a face of the box, and nothing else meets.
TEST(Components, AShellThatTouchesWithAllItsCornersTakesAPointWithinAnEdge) {
  PolygonMesh mesh;
  mesh.positions = {{0, 2, 1}, {4, 2, 1.5}, {2, 0, 2}, {2, 3, 0}};
  mesh.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  mesh.face_sizes = {3, 3, 3, 3};
  const Solid box = block({0, 0, 0}, {4, 4, 4}), tetrahedron = Solid::from_mesh(mesh);
  Phases phases(box, tetrahedron, Operation::subtract);
  EXPECT_EQ(phases.contacts().contacts.size(), 4u);
  EXPECT_TRUE(phases.contacts().segments.empty());
  expect_kept(box, tetrahedron, Operation::subtract, 6, 4);
  expect_kept(box, tetrahedron, Operation::unite, 6, 0);
}

TEST(PointInSolid, IsAnsweredForLoadedAndUnloadedFaces) {
  Phases phases(block({0, 0, 0}, {2, 2, 2}), block({5, 5, 5}, {6, 6, 6}), Operation::unite);
  Geometry& g = phases.w.geometry;
  const PointId within = g.add_point(Vec3{1, 1, 1}), level = g.add_point(Vec3{-1, 2, 2}),
                beside = g.add_point(Vec3{3, 1, 1});
  phases.w.kernel->refresh();
  PointInSolid in_a(phases.w, Operand::a), in_b(phases.w, Operand::b);
  EXPECT_TRUE(in_a(within));
  EXPECT_FALSE(in_a(level));  // the ray runs along an edge
  EXPECT_FALSE(in_a(beside));
  EXPECT_FALSE(in_b(within));
}

}  // namespace
}  // namespace sectile
