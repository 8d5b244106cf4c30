#include "evaluation/evaluator.h"

#include <gtest/gtest.h>

#include <thread>

#include "evaluation/scene_computation.h"
#include "scene/exact_moves.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

Node block(double x, double y = 0, double z = 0) {
  Node node;
  node.what = Primitive();
  node.placement.position = {x, y, z};
  return node;
}

Node sphere(std::uint32_t segments, std::uint32_t rings) {
  Primitive p;
  p.kind = &primitive_kind("sphere");
  p.segments = segments;
  p.rings = rings;
  Node node;
  node.what = p;
  return node;
}

TEST(Evaluate, SolidsAreInTheWorldAndSurfacesInTheirNode) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(1));
  const NodeId both = scene.combine({a, b}, Operation::subtract);
  scene.edit(both).placement.position.z = 10;
  const Evaluation made = evaluate(scene);
  EXPECT_EQ(made.find(both)->solid.volume(), 4);
  EXPECT_EQ(made.find(a)->solid, sectile::block({-1, -1, 9}, {1, 1, 11}));
  EXPECT_EQ(made.find(both)->solid, sectile::block({-1, -1, 9}, {0, 1, 11}));
  EXPECT_EQ(made.find(both)->bounds.low, glm::dvec3(-1, -1, 9));
  EXPECT_EQ(made.find(both)->surface->bounds.high, glm::dvec3(0, 1, 1));
  EXPECT_EQ(made.find(both)->model[3].z, 10);
  EXPECT_EQ(bounds_of(made, scene, {b}).high, glm::dvec3(2, 1, 11));
}

// Corners rounded to doubles would leave the planes of slanted faces, which then fall apart.
TEST(Evaluate, AMovedSolidKeepsItsNumberOfFaces) {
  Transform shear;
  shear.m = {1, 0.5, 0.25, 0, 0.25, 1, 0.5, 0, 0.5, 0.25, 1, 0};
  PolygonMesh mesh;
  for (const double z : {-1, 1})
    for (const double y : {-1, 1})
      for (const double x : {-1, 1}) mesh.positions.push_back({x, y, z});
  mesh.face_sizes.assign(6, 4);
  mesh.indices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  mesh = transformed(mesh, shear);
  Scene scene;
  Node node;
  node.what = Imported{"", std::make_shared<PolygonMesh>(mesh)};
  node.placement.position = {0.1, -0.7, 1.0 / 3};
  const NodeId id = scene.add(node);
  const Evaluation made = evaluate(scene);
  EXPECT_EQ(made.find(id)->inside.counts().faces, 6u);
  EXPECT_EQ(made.find(id)->solid.counts().faces, 6u);
}

TEST(Evaluate, OperandsAndResultsStandWhereTheirRemaindersSay) {
  Scene scene;
  const NodeId a = scene.add(block(0.1)), b = scene.add(block(7));
  scene.edit(b).placement = moved_onto(scene.at(b).placement, {}, {{}, {{-1, 0, 0}}},
                                       {scene.exact_world(a), {{1, 0, 0}}}, {true, false, false})
                                .placement;
  const Evaluation apart = evaluate(scene);
  EXPECT_EQ(boolean(apart.find(a)->solid, apart.find(b)->solid, Operation::unite).counts().faces,
            6u);
  const NodeId both = scene.combine({a, b}, Operation::unite);
  scene.edit(both).placement = {{0.3, 0, 0}, {0, 0, 0}, {1, 1, 1}, {0x1p-70, 0, 0}};
  const Evaluation made = evaluate(scene);
  EXPECT_EQ(made.find(both)->solid.counts().faces, 6u);
  EXPECT_EQ(made.find(both)->solid, transformed(made.find(both)->inside, scene.exact_world(both)));
  EXPECT_EQ(made.find(b)->solid, transformed(made.find(b)->inside, scene.exact_world(b)));
}

TEST(Evaluate, FoldsInOrder) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(1)), c = scene.add(block(-1.5));
  const NodeId made = scene.combine({a, b, c}, Operation::subtract);
  EXPECT_EQ(evaluate(scene).find(made)->solid, sectile::block({-0.5, -1, -1}, {0, 1, 1}));
  std::get<BooleanNode>(scene.edit(made).what).operation = Operation::intersect;
  EXPECT_TRUE(evaluate(scene).find(made)->solid.is_empty());
  std::get<BooleanNode>(scene.edit(made).what).operation = Operation::unite;
  EXPECT_EQ(evaluate(scene).find(made)->solid.volume(), 4.5 * 4);
}

TEST(Evaluate, CutsMoveWithTheirNode) {
  Scene scene;
  const auto [above, below] = scene.split(scene.add(block(0)), {1, 0, 0, -0.5});
  scene.edit(above).placement.position.x = 100;
  const Evaluation made = evaluate(scene);
  EXPECT_EQ(made.find(above)->solid, sectile::block({100.5, -1, -1}, {101, 1, 1}));
  EXPECT_EQ(made.find(below)->solid, sectile::block({-1, -1, -1}, {0.5, 1, 1}));
}

TEST(Evaluate, GroupsAreUnitedWhereAnOperationNeedsThem) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(4)), c = scene.add(block(1));
  const NodeId group = scene.group({a, b});
  EXPECT_TRUE(evaluate(scene).find(group)->solid.is_empty());
  const NodeId made = scene.combine({group, c}, Operation::subtract);
  EXPECT_EQ(evaluate(scene).find(group)->solid.volume(), 16);
  EXPECT_EQ(evaluate(scene).find(made)->solid.volume(), 12);
}

TEST(Evaluate, ErrorsStayWithTheirNodesAndTellTheOnesAbove) {
  Scene scene;
  Node bad = block(0);
  std::get<Primitive>(bad.what).size.x = -1;
  Node open;
  auto mesh = std::make_shared<PolygonMesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->face_sizes = {3};
  mesh->indices = {0, 1, 2};
  open.what = Imported{"open.obj", mesh};
  const NodeId a = scene.add(bad), b = scene.add(block(0)), c = scene.add(open);
  const NodeId made = scene.combine({b, a}, Operation::unite);
  const Evaluation evaluation = evaluate(scene);
  EXPECT_NE(evaluation.find(a)->error.find("size along x"), std::string::npos);
  EXPECT_NE(evaluation.find(made)->error.find("\"Block\" is no solid"), std::string::npos);
  EXPECT_FALSE(evaluation.find(c)->error.empty());
  EXPECT_EQ(evaluation.find(c)->surface, nullptr);
  EXPECT_EQ(evaluation.find(b)->error, "");
  EXPECT_EQ(evaluation.find(b)->solid.volume(), 8);
}

TEST(Evaluate, HiddenNodesTakePartButHaveNoSurface) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(1));
  const NodeId made = scene.combine({a, b}, Operation::unite);
  scene.edit(b).visible = false;
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(evaluation.find(made)->solid.volume(), 12);
  EXPECT_EQ(evaluation.find(b)->surface, nullptr);
  EXPECT_TRUE(evaluation.find(b)->bounds.is_empty());
  EXPECT_NE(evaluation.find(a)->surface, nullptr);
}

TEST(SceneComputation, WhatDidNotChangeIsNotComputedAgain) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(1)), c = scene.add(block(7));
  const NodeId inner = scene.combine({a, b}, Operation::unite);
  const NodeId outer = scene.combine({inner, c}, Operation::unite);
  SceneComputation computation;
  const Evaluation first = computation.run(scene, nullptr, {});
  const Evaluation same = computation.run(scene, nullptr, {});
  EXPECT_EQ(same.find(outer)->solid.data(), first.find(outer)->solid.data());
  // A moved subtree keeps its surface; what is above it is new.
  scene.edit(inner).placement.position.y = 0.5;
  const Evaluation moved = computation.run(scene, nullptr, {});
  EXPECT_EQ(moved.find(inner)->surface, first.find(inner)->surface);
  EXPECT_NE(moved.find(outer)->surface, first.find(outer)->surface);
  EXPECT_EQ(moved.find(c)->solid.data(), first.find(c)->solid.data());
  // Back again, by undo: all is still known.
  scene.edit(inner).placement.position.y = 0;
  const Evaluation back = computation.run(scene, nullptr, {});
  EXPECT_EQ(back.find(outer)->solid.data(), first.find(outer)->solid.data());
  // Equal subtrees are computed once.
  const NodeId copy = scene.duplicate(outer);
  EXPECT_EQ(computation.run(scene, nullptr, {}).find(copy)->solid.data(),
            first.find(outer)->solid.data());
}

TEST(SceneComputation, CancelsBetweenSteps) {
  Scene scene;
  const NodeId a = scene.add(sphere(64, 32)), b = scene.add(sphere(64, 32));
  scene.edit(b).placement.position.x = 0.5;
  const NodeId made = scene.combine({a, b}, Operation::unite);
  SceneComputation computation;
  std::atomic<bool> cancel{false};
  double last = 0;
  const auto stop_inside = [&](double done) {
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    last = done;
    if (done > 0.3) cancel = true;
  };
  EXPECT_THROW(computation.run(scene, &cancel, stop_inside), Cancelled);
  EXPECT_GT(last, 0.3);
  EXPECT_LT(last, 0.5);
  EXPECT_EQ(computation.run(scene, nullptr, {}).find(made)->error, "");
}

TEST(Evaluator, GivesTheNewestRequestInTheEnd) {
  Scene scene;
  const NodeId a = scene.add(block(0)), b = scene.add(block(1));
  const NodeId made = scene.combine({a, b}, Operation::unite);
  Evaluator evaluator;
  EXPECT_EQ(evaluator.latest(), nullptr);
  std::uint64_t last = 0;
  for (int i = 0; i < 100; ++i) {
    scene.edit(b).placement.position.x = 0.01 * i;
    last = evaluator.request(scene);
  }
  evaluator.wait();
  EXPECT_TRUE(evaluator.is_busy()) << "its result was not taken yet";
  EXPECT_EQ(evaluator.latest()->request, last);
  EXPECT_FALSE(evaluator.is_busy());
  EXPECT_EQ(evaluator.latest()->find(made)->solid, evaluate(scene).find(made)->solid);
}

TEST(Evaluator, ADragShowsResultsAllTheTime) {
  Scene scene;
  const NodeId a = scene.add(sphere(64, 32)), b = scene.add(sphere(32, 16));
  scene.combine({a, b}, Operation::unite);
  Evaluator evaluator;
  evaluator.request(scene);
  evaluator.wait();
  const std::uint64_t before = evaluator.latest()->request;
  // Requests come faster than results.
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  for (int i = 0; evaluator.latest()->request < before + 3; ++i) {
    ASSERT_LT(std::chrono::steady_clock::now(), end);
    scene.edit(b).placement.position.x = 0.001 * i;
    evaluator.request(scene);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Evaluator, SavesBeforeItWorksAndOutlivesErrorsThere) {
  std::atomic<int> calls{0};
  Evaluator evaluator([&](const Scene&) {
    if (++calls == 2) throw std::runtime_error("The disk is full.");
  });
  Scene scene;
  const NodeId a = scene.add(block(0));
  evaluator.request(scene);
  evaluator.wait();
  EXPECT_EQ(evaluator.latest()->find(a)->error, "");
  evaluator.request(scene);
  evaluator.wait();
  EXPECT_EQ(evaluator.latest()->find(a)->error, "The disk is full.");
  evaluator.request(scene);
  evaluator.wait();
  EXPECT_EQ(evaluator.latest()->find(a)->solid.volume(), 8);
  EXPECT_EQ(calls, 3);
}

TEST(Evaluator, CancelEndsTheWorkAndKeepsWhatWasShown) {
  Evaluator evaluator;
  Scene scene;
  const NodeId a = scene.add(sphere(512, 256)), b = scene.add(sphere(512, 256));
  scene.edit(b).placement.rotation = {10, 20, 30};
  scene.combine({a, b}, Operation::unite);
  evaluator.request(scene);
  EXPECT_TRUE(evaluator.is_busy());
  evaluator.cancel();
  evaluator.wait();
  EXPECT_FALSE(evaluator.is_busy());
  EXPECT_EQ(evaluator.latest(), nullptr);
}

}  // namespace
}  // namespace sectile::viewer
