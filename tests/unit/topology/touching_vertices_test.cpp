#include "topology/touching_vertices.h"

#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

// Their points, each as often as there are vertices.
std::vector<Vec3> touching_points(const Solid& solid) {
  std::vector<Vec3> points;
  for (const VertexId v : touching_vertices(solid.data()->brep()))
    points.push_back(solid.data()->geometry().position(solid.data()->brep().point_of(v)));
  return points;
}

Solid united(const Solid& a, const Solid& b) {
  return boolean(a, b, Operation::unite);
}
Solid two_blocks_at_an_edge() {
  return united(block({0, 0, 0}, {1, 1, 1}), block({1, 1, 0}, {2, 2, 1}));
}

TEST(TouchingVertices, AreNoneWhereNothingTouches) {
  EXPECT_TRUE(touching_points(block({0, 0, 0}, {1, 1, 1})).empty());
  EXPECT_TRUE(touching_points(cone(1, 0, 1, 100)).empty());
  EXPECT_TRUE(touching_points(torus(2, 1, 12, 8)).empty());
}

TEST(TouchingVertices, AreThoseOfBothBlocksThatMeetAtAnEdge) {
  const std::vector<Vec3> points = touching_points(two_blocks_at_an_edge());
  ASSERT_EQ(points.size(), 4u);
  for (const Vec3& p : points) {
    EXPECT_EQ(p.x, 1);
    EXPECT_EQ(p.y, 1);
  }
}

TEST(TouchingVertices, AreThoseOfBothBlocksThatMeetAtACorner) {
  const Solid two = united(block({0, 0, 0}, {1, 1, 1}), block({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(touching_points(two), (std::vector<Vec3>{{1, 1, 1}, {1, 1, 1}}));
}

// Each end of the edge is one vertex of the cavity: its material is around in one piece.
TEST(TouchingVertices, AreTheEndsOfTwoEdgesThatHaveThemInCommon) {
  const Solid mould =
      boolean(block({-1, -1, -1}, {3, 3, 3}), two_blocks_at_an_edge(), Operation::subtract);
  EXPECT_EQ(touching_points(mould).size(), 2u);
  EXPECT_EQ(mould.counts().vertices, 8u + 14u);
}

// Below, the material parts at the edge; above, it does not.
TEST(TouchingVertices, AreTheEndsOfTwoEdgesThatHaveOneOfThemInCommon) {
  const Solid mould =
      boolean(block({-1, -1, 0}, {3, 3, 3}), two_blocks_at_an_edge(), Operation::subtract);
  EXPECT_EQ(touching_points(mould).size(), 3u);
}

}  // namespace
}  // namespace sectile
