// Distances, angles and radii.
#include "scene/measuring.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sectile::viewer {
namespace {

Measured vertex(const Vec3& p) {
  Measured made;
  made.point = p;
  return made;
}
Measured edge(const Vec3& from, const Vec3& to) {
  Measured made;
  made.kind = Measured::Kind::edge;
  made.from = from, made.to = to;
  return made;
}
Measured face(const Vec3& point, const Vec3& normal) {
  Measured made;
  made.kind = Measured::Kind::face;
  made.point = point, made.normal = normal;
  return made;
}

double value(const Measurement& measurement, const std::string& name) {
  for (const Measurement::Fact& fact : measurement.facts)
    if (fact.name == name) return fact.value;
  return NAN;
}

TEST(Measuring, Vertices) {
  const Measurement m = measured(vertex({1, 2, 3}), vertex({4, 6, 3}));
  EXPECT_EQ(value(m, "Distance"), 5);
  EXPECT_EQ(value(m, "dx"), 3);
  EXPECT_EQ(value(m, "dy"), 4);
  EXPECT_TRUE(std::isnan(value(m, "dz"))) << "what is zero is not told";
  EXPECT_EQ(m.shown, (std::vector<Vec3>{{1, 2, 3}, {4, 6, 3}}));
}

TEST(Measuring, AVertexAndAnEdgeOrAFace) {
  EXPECT_EQ(value(measured(vertex({5, 3, 4}), edge({0, 0, 0}, {9, 0, 0})), "Distance"), 5);
  EXPECT_EQ(value(measured(edge({0, 0, 0}, {1, 0, 0}), vertex({4, 4, 0})), "Distance"), 5)
      << "beyond its end";
  EXPECT_EQ(value(measured(vertex({5, 3, 4}), face({0, 0, 1}, {0, 0, 1})), "Distance"), 3);
}

TEST(Measuring, Edges) {
  const Measurement skew = measured(edge({-1, 0, 0}, {1, 0, 0}), edge({0, -1, 2}, {0, 1, 2}));
  EXPECT_EQ(value(skew, "Distance"), 2);
  EXPECT_EQ(value(skew, "Angle"), 90);
  const Measurement aligned = measured(edge({0, 0, 0}, {1, 0, 0}), edge({5, 3, 0}, {4, 3, 0}));
  EXPECT_EQ(value(aligned, "Distance"), std::hypot(3, 3));
  EXPECT_EQ(value(aligned, "Angle"), 0);
  EXPECT_EQ(value(measured(edge({1, 1, 1}, {1, 1, 4})), "Length"), 3);
}

TEST(Measuring, Faces) {
  const Measurement level = measured(face({0, 0, 0}, {0, 0, -1}), face({5, 5, 2}, {0, 0, 1}));
  EXPECT_EQ(value(level, "Distance"), 2);
  EXPECT_EQ(value(level, "Angle"), 0);
  const double half = std::sqrt(0.5);
  const Measurement roof = measured(face({0, 0, 0}, {half, 0, half}), face({}, {-half, 0, half}));
  EXPECT_TRUE(std::isnan(value(roof, "Distance")));
  EXPECT_NEAR(value(roof, "Angle"), 90, 1e-12);
  EXPECT_NEAR(value(measured(edge({}, {1, 0, 1}), face({}, {0, 0, 1})), "Angle"), 45, 1e-12);
}

std::size_t edge_at_height(const SnapFeatures& features, double z) {
  for (std::size_t i = 0; i < features.edges.size(); ++i)
    if (features.edges[i].from.z == z && features.edges[i].to.z == z) return i;
  throw std::runtime_error("There is no such edge.");
}

TEST(Measuring, TheRimOfACylinderIsACircle) {
  const SnapFeatures features = snap_features(cylinder(3, 2, 24));
  const std::optional<Circle> circle = circle_through(features, edge_at_height(features, 2));
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 3, 1e-12);
  EXPECT_NEAR(circle->centre.z, 2, 1e-12);
  EXPECT_TRUE(circle->is_closed);
  EXPECT_EQ(circle->corners, 24u);
}

TEST(Measuring, AnArcIsACircleToo) {
  const Solid half =
      boolean(cylinder(3, 2, 24), block({-5, -5, -1}, {5, 0, 5}), Operation::subtract);
  const SnapFeatures features = snap_features(half);
  std::optional<Circle> longest;
  for (std::size_t i = 0; i < features.edges.size(); ++i) {
    const auto circle = circle_through(features, i);
    if (circle && circle->normal.z * circle->normal.z > 0.99) longest = circle;
  }
  ASSERT_TRUE(longest);
  EXPECT_NEAR(longest->radius, 3, 1e-12);
  EXPECT_FALSE(longest->is_closed);
  EXPECT_EQ(longest->corners, 13u);
}

TEST(Measuring, ABlockHasNoCircles) {
  const SnapFeatures features = snap_features(block({0, 0, 0}, {1, 1, 1}));
  for (std::size_t i = 0; i < features.edges.size(); ++i)
    EXPECT_FALSE(circle_through(features, i)) << i;
}

}  // namespace
}  // namespace sectile::viewer
