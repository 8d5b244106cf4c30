#include "scene/picking.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "picture/surface_mesh.h"
#include "scene/snapping.h"

namespace sectile::viewer {
namespace {

PickTarget target_of(const Solid& solid, NodeId node) {
  return {node, surface_mesh(solid), glm::dmat4(1)};
}

TEST(Picker, FindsTheNearestSurface) {
  Picker picker;
  std::vector<PickTarget> targets{target_of(block({-1, -1, -1}, {1, 1, 1}), 1),
                                  target_of(block({-1, -1, 3}, {1, 1, 4}), 2)};
  const Ray down{{0.25, 0.5, 10}, {0, 0, -1}};
  auto hit = picker.pick(down, targets);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->node, 2u);
  EXPECT_EQ(hit->point, glm::dvec3(0.25, 0.5, 4));
  EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(hit->distance, 6);
  targets[1].model[3].x = 50;
  EXPECT_EQ(picker.pick(down, targets)->node, 1u);
  EXPECT_FALSE(picker.pick({{9, 0, 10}, {0, 0, -1}}, targets));
  EXPECT_FALSE(picker.pick({{0, 0, 10}, {0, 0, 1}}, targets));
  const SectionPlane section{true, {0, 0, 1, 0}};  // all above the ground is cut away
  EXPECT_EQ(picker.pick(down, targets, section)->point.z, -1);
}

TEST(Picker, AgreesWithAllTriangles) {
  Picker picker;
  const std::vector<PickTarget> targets{target_of(torus(2, 0.7, 40, 20), 1)};
  const SurfaceMesh& mesh = *targets[0].mesh;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-3, 3);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 origin{any(random), any(random), 5}, to{any(random), any(random), -5};
    const Ray ray{origin, glm::normalize(to - origin)};
    const auto hit = picker.pick(ray, targets);
    double nearest = 1e300;
    for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
      const glm::dvec3 a = mesh.positions[3 * t],
                       n = glm::cross(glm::dvec3(mesh.positions[3 * t + 1]) - a,
                                      glm::dvec3(mesh.positions[3 * t + 2]) - a);
      const double s = glm::dot(a - ray.origin, n) / glm::dot(ray.direction, n);
      const glm::dvec3 p = ray.origin + s * ray.direction;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 from = mesh.positions[3 * t + k],
                         to_next = mesh.positions[3 * t + (k + 1) % 3];
        inside = inside && glm::dot(glm::cross(to_next - from, p - from), n) >= 0;
      }
      if (inside) nearest = std::min(nearest, s);
    }
    ASSERT_EQ(hit.has_value(), nearest < 1e300) << i;
    if (!hit) continue;
    EXPECT_NEAR(hit->distance, nearest, 1e-9);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

TEST(Picker, IsFastWithManyTriangles) {
  Picker picker;
  const std::vector<PickTarget> targets{target_of(sphere(1, 320, 160), 1)};
  ASSERT_GT(targets[0].mesh->faces.size(), 100'000u);
  picker.pick({{0, 0, 5}, {0, 0, -1}}, targets);  // builds the tree
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i)
    EXPECT_TRUE(picker.pick({{0.0009 * i, 0.0001 * i, 5}, {0, 0, -1}}, targets));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("microseconds_per_pick", std::to_string(seconds * 1000));
  EXPECT_LT(seconds, 1) << "a pick takes more than a millisecond";
}

TEST(Picker, PrefersVerticesToEdgesToFaces) {
  Picker picker;
  const std::vector<PickTarget> targets{target_of(block({-1, -1, -1}, {1, 1, 1}), 7)};
  Camera camera;
  camera.target = {0, 0, 0};
  const glm::dvec2 size{800, 600};
  const auto feature_at = [&](const glm::dvec3& p, glm::dvec2 off) {
    return picker.pick_feature(camera, glm::dvec2(camera.project(p, size)) + off, size, 8, targets);
  };
  const glm::dvec3 eye = camera.position();
  const glm::dvec3 corner{eye.x > 0 ? 1 : -1, eye.y > 0 ? 1 : -1, 1};
  auto found = feature_at(corner, {3, 2});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PickedFeature::Kind::vertex);
  EXPECT_EQ(found->point, corner);
  found = feature_at({0, corner.y, 1}, {1, 2});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PickedFeature::Kind::edge);
  EXPECT_NEAR(found->point.y, corner.y, 1e-9);
  found = feature_at({0, 0, 1}, {0, 0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PickedFeature::Kind::face);
  EXPECT_EQ(found->normal, glm::dvec3(0, 0, 1));
  // The corner behind is hidden.
  found = feature_at({-corner.x, -corner.y, -1}, {0, 0});
  EXPECT_TRUE(!found || found->point.z != -1 || found->point.x != -corner.x);
}

TEST(Snapping, ToGridAndAngles) {
  EXPECT_EQ(snapped(0.26, 0.1), 0.3);
  EXPECT_EQ(snapped(-0.04, 0.1), 0);
  EXPECT_EQ(snapped(37, 15), 30);
  EXPECT_EQ(snapped(1.3, 0), 1.3);
}

Placement at(double x, double y, double z) {
  return {{x, y, z}, {0, 0, 0}, {1, 1, 1}};
}

// A drag against one solid that stands still.
std::vector<Snap> snap(const SnapFeatures& dragged, const SnapFeatures& fixed, const Vec3& offset,
                       double reach, const SnapDirections& directions = all_directions()) {
  const SnapTargets targets(fixed);
  return snap(dragged, {&targets}, offset, reach, directions).contacts;
}

/// Of one solid whose node has no parent.
Landing placed_by(const Placement& start, const Vec3& offset, const std::vector<Snap>& contacts) {
  const Landings made = placed_by({DraggedNode{start, {}}}, offset, contacts);
  return {made.placements.front(), made.is_exact};
}

TEST(Snapping, BlocksFindTheirCornerExactly) {
  const Solid inside = block({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05});
  const SnapFeatures fixed = snap_features(block({0.1, 0.1, 0.1}, {0.7, 0.9, 1.1}));
  EXPECT_EQ(fixed.vertices.size(), 8u);
  EXPECT_EQ(fixed.edges.size(), 12u);
  EXPECT_EQ(fixed.faces.size(), 6u);
  const Placement start = at(3, 3, 3);
  const SnapFeatures dragged = snap_features(inside, start.transform());
  const Vec3 offset{-3 + 0.751, -3 + 0.948, -3 + 1.052};
  const std::vector<Snap> snaps = snap(dragged, fixed, offset, 0.01);
  ASSERT_EQ(snaps.size(), 1u);
  EXPECT_EQ(snaps[0].kind, Snap::Kind::vertex_vertex);
  const Landing made = placed_by(start, offset, snaps);
  EXPECT_TRUE(made.is_exact);
  EXPECT_TRUE(are_equal({made.placement.exact(), snaps[0].moved[0]}, ExactSum::of(snaps[0].to),
                        {true, true, true}));
}

TEST(Snapping, FacesBecomeFlush) {
  const Solid inside = block({-0.15, -0.15, -0.15}, {0.15, 0.15, 0.15});
  const Solid wall = block({0.1, -5, -5}, {0.7, 5, 5});
  const Placement start = at(2, 0.123, 0.321);
  const SnapFeatures dragged = snap_features(inside, start.transform());
  const Vec3 offset{-1.143, 0.01, 0.02};  // left side near x = 0.7
  const std::vector<Snap> snaps = snap(dragged, snap_features(wall), offset, 0.02);
  ASSERT_EQ(snaps.size(), 1u);
  EXPECT_EQ(snaps[0].kind, Snap::Kind::face_face);
  EXPECT_EQ(snaps[0].shown.size(), 8u) << "the four sides of the wall's face";
  for (const Vec3& p : snaps[0].shown) EXPECT_EQ(p.x, 0.7);
  const Landing landing = placed_by(start, offset, snaps);
  EXPECT_TRUE(landing.is_exact);
  const Placement& made = landing.placement;
  EXPECT_EQ(made.position.x, 0.85);
  EXPECT_EQ(made.position.y, 0.123 + 0.01);
  // Exactly flush: one shell, and the walls of the contact are gone.
  const Solid placed = transformed(inside, made.exact());
  EXPECT_EQ(placed.counts().faces, inside.counts().faces);
  EXPECT_EQ(boolean(placed, wall, Operation::unite).counts().shells, 1u);
  EXPECT_TRUE(boolean(placed, wall, Operation::intersect).is_empty());
}

TEST(Snapping, KeepsToTheDirectionsOfTheDrag) {
  const SnapFeatures fixed = snap_features(block({0, 0, 0}, {1, 1, 1}));
  const SnapFeatures dragged = snap_features(block({2, 0.4, 0.4}, {3, 0.6, 0.6}));
  const auto free = snap(dragged, fixed, {-0.98, 0, 0}, 0.05);
  const auto along_x = snap(dragged, fixed, {-0.98, 0, 0}, 0.05, {{1, 0, 0}});
  const auto along_y = snap(dragged, fixed, {-0.98, 0, 0}, 0.05, {{0, 1, 0}});
  ASSERT_FALSE(free.empty());
  ASSERT_EQ(along_x.size(), 1u);
  EXPECT_EQ(along_x[0].offset, (Vec3{-1, 0, 0}));
  EXPECT_TRUE(along_y.empty());
}

TEST(Snapping, TellsSlantedContactsFromExactOnes) {
  const Solid roof =
      transformed(block({-1, -1, -1}, {1, 1, 1}), Transform::rotation_degrees({1, 0, 0}, 30));
  const SnapFeatures fixed = snap_features(roof);
  const Placement start{{0, 0, 5}, {30, 0, 0}, {1, 1, 1}};
  const SnapFeatures dragged =
      snap_features(block({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), start.transform());
  const Vec3 normal = Transform::rotation_degrees({1, 0, 0}, 30)({0, 0, 1});
  const Vec3 offset{0, 0.1 * normal.y, -5 + 1.51 * normal.z};
  const auto snaps = snap(dragged, fixed, {0, 1.51 * normal.y, -5 + 1.51 * normal.z}, 0.05);
  ASSERT_EQ(snaps.size(), 1u);
  EXPECT_EQ(snaps[0].kind, Snap::Kind::face_face);
  EXPECT_FALSE(snaps[0].is_expressible);
  EXPECT_FALSE(placed_by(start, offset, snaps).is_exact);
  // Its sides are not slanted.
  const auto beside = snap(dragged, fixed, {1.51, 0, -5}, 0.05, {{1, 0, 0}});
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_TRUE(placed_by(start, {1.51, 0, -5}, beside).is_exact);
}

TEST(Snapping, IsFastAgainstManyTriangles) {
  const SnapTargets many(snap_features(sphere(1, 320, 160)));
  const SnapFeatures dragged = snap_features(sphere(0.5, 32, 16));
  const auto start = std::chrono::steady_clock::now();
  int found = 0;
  for (int i = 0; i < 20; ++i)
    found += !snap(dragged, {&many}, {1.5 + 0.001 * i, 0, 0}, 0.02).contacts.empty();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds_per_search", std::to_string(seconds * 50));
  EXPECT_GT(found, 0);
  EXPECT_LT(seconds, 2) << "a search takes more than a tenth of a second";
  EXPECT_TRUE(snap(many.features(), {&many}, {0.001, 0, 0}, 0.1).gave_up);
}

// Sums of two doubles hold what sums of few doubles make: only a turned parent has none as a rule.
TEST(Snapping, MovesAPointExactlyOntoATarget) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const ExactTransform parents[]{{}, Placement{{0.1, 0.2, 0.3}, {90, 0, 0}, {1, 1, 1}}.exact()};
  for (int i = 0; i < 400; ++i) {
    const Placement start{{any(random), any(random), any(random)}, {0, 90, 0}, {1, 2, 0.5}};
    const ExactSum local({}, {{any(random), any(random), any(random)}});
    const ExactSum target = ExactSum::of({24 + any(random), any(random), any(random)});
    const Landing made = moved_onto(start, parents[i % 2], local, target);
    EXPECT_TRUE(made.is_exact);
    EXPECT_TRUE(are_equal(local.mapped(parents[i % 2] * made.placement.exact()), target,
                          {true, true, true}));
  }
}

TEST(Snapping, SaysThatAPointInATurnedParentComesNear) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  int exact = 0;
  for (int i = 0; i < 200; ++i) {
    const ExactTransform parent = Placement{{any(random), 0, 0}, {10, 20, 30}, {1, 1, 1}}.exact();
    const ExactSum local({}, {{any(random), any(random), any(random)}});
    const ExactSum target = ExactSum::of({9 + any(random), 0, 0});
    const Coordinates x{true, false, false};
    const Landing made = moved_onto({}, parent, local, target, x);
    const ExactSum reached = local.mapped(parent * made.placement.exact());
    exact += made.is_exact;
    EXPECT_EQ(are_equal(reached, target, x), made.is_exact);
    EXPECT_LT(std::abs(ExactSum(target).add(reached, -1).value().x), 1e-30);
  }
  EXPECT_LT(exact, 200);
}

// Two blocks that are flush between doubles are dragged together onto a third one.
TEST(Snapping, NodesThatAreDraggedTogetherStayFlush) {
  const Solid cube = block({-0.15, -0.15, -0.15}, {0.15, 0.15, 0.15});
  const Placement left = at(0.1, 0, 0);
  const ExactSum side(left.exact(), {{0.15, 0, 0}});
  const Landing right =
      moved_onto(at(1, 0, 0), {}, {{}, {{-0.15, 0, 0}}}, side, {true, false, false});
  ASSERT_TRUE(right.is_exact);
  const SnapFeatures wall = snap_features(block({1.7, -5, -5}, {2.3, 5, 5}));
  SnapFeatures dragged;
  dragged.add(snap_features(cube, left.transform()), 0);
  dragged.add(snap_features(cube, right.placement.transform()), 1);
  const Vec3 offset{1.16, 0.01, 0};
  const std::vector<Snap> snaps = snap(dragged, wall, offset, 0.02);
  ASSERT_EQ(snaps.size(), 1u);
  const Landings made =
      placed_by({DraggedNode{left, {}, {ExactTransform(), std::nullopt}},
                 DraggedNode{right.placement, {}, {std::nullopt, ExactTransform()}}},
                offset, snaps);
  EXPECT_TRUE(made.is_exact);
  const Solid a = transformed(cube, made.placements[0].exact());
  const Solid b = transformed(cube, made.placements[1].exact());
  EXPECT_EQ(boolean(a, b, Operation::unite).counts().faces, 6u);
  EXPECT_EQ(boolean(b, block({1.7, -5, -5}, {2.3, 5, 5}), Operation::unite).counts().shells, 1u);
  EXPECT_TRUE(boolean(b, block({1.7, -5, -5}, {2.3, 5, 5}), Operation::intersect).is_empty());
}

}  // namespace
}  // namespace sectile::viewer
