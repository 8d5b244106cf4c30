// Arrays and mirrors: where the copies stand, and the solids that they make.
#include "scene/pattern.h"

#include <gtest/gtest.h>

#include "evaluation/evaluator.h"
#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

/// A block of edge 2 at (4, 0, 0) below a pattern.
struct Repeated {
  explicit Repeated(const Pattern& pattern) {
    Node node;
    node.what = pattern;
    top = scene.add(node);
    Node block;
    block.what = Primitive();
    block.placement.position = {4, 0, 0};
    child = scene.add(block, top);
  }
  Evaluation::Entry result() const { return *evaluate(scene).find(top); }
  Scene scene;
  NodeId top = 0, child = 0;
};

TEST(Patterns, ARow) {
  Pattern pattern;
  pattern.count = 4;
  pattern.step = {0.1, 3, 0};
  const auto places = copies_of(pattern);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places[0].m, Transform().m);
  EXPECT_EQ(places[3]({0, 0, 0}), (Vec3{3 * 0.1, 9, 0}));
  const Repeated repeated(pattern);
  EXPECT_EQ(repeated.result().solid.volume(), 32);
  EXPECT_EQ(repeated.result().solid.counts().shells, 4u);
}

TEST(Patterns, RightAnglesOfARingAreExact) {
  Pattern pattern;
  pattern.kind = Pattern::Kind::polar;
  pattern.count = 4;
  pattern.centre = {1, 2, 0};
  const auto places = copies_of(pattern);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places[1]({4, 2, 7}), (Vec3{1, 5, 7}));
  EXPECT_EQ(places[2]({4, 2, 7}), (Vec3{-2, 2, 7}));
  EXPECT_EQ(places[3]({4, 2, 7}), (Vec3{1, -1, 7}));
  pattern.degrees = 90;  // from end to end
  pattern.count = 2;
  EXPECT_EQ(copies_of(pattern)[1]({4, 2, 7}), (Vec3{1, 5, 7}));
}

TEST(Patterns, APathKeepsItsCorners) {
  Pattern pattern;
  pattern.kind = Pattern::Kind::path;
  pattern.path = {{1, 1, 0}, {5, 1, 0}, {5, 5, 0}};
  const auto places = copies_of(pattern);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].m, Transform().m);
  EXPECT_EQ(places[1]({1, 1, 0}), (Vec3{5, 1, 0}));
  EXPECT_EQ(places[2]({1, 1, 0}), (Vec3{5, 5, 0}));
  EXPECT_EQ(places[2]({2, 1, 0}), (Vec3{5, 6, 0})) << "turned with the path";
  pattern.turns = false;
  EXPECT_EQ(copies_of(pattern)[2]({2, 1, 0}), (Vec3{6, 5, 0}));
}

TEST(Patterns, AMirrorWithAndWithoutTheOriginal) {
  Pattern pattern;
  pattern.kind = Pattern::Kind::mirror;
  pattern.axis = {1, 0, 0};
  pattern.centre = {1, 0, 0};
  Repeated repeated(pattern);
  EXPECT_EQ(repeated.result().solid.volume(), 16);
  EXPECT_EQ(repeated.result().bounds.low.x, -3);
  EXPECT_EQ(repeated.result().bounds.high.x, 5);
  std::get<Pattern>(repeated.scene.edit(repeated.top).what).keeps = false;
  EXPECT_EQ(repeated.result().solid.volume(), 8);
  EXPECT_EQ(repeated.result().bounds.high.x, -1);
}

TEST(Patterns, CopiesThatTouchBecomeOneSolid) {
  Pattern pattern;
  pattern.count = 5;
  pattern.step = {2, 0, 0};
  const Evaluation::Entry result = Repeated(pattern).result();
  EXPECT_EQ(result.solid.volume(), 40);
  EXPECT_EQ(result.solid.counts().shells, 1u);
}

TEST(Patterns, WhatCannotBeIsSaid) {
  Pattern pattern;
  pattern.kind = Pattern::Kind::polar;
  pattern.axis = {0, 0, 0};
  EXPECT_THROW(copies_of(pattern), std::invalid_argument);
  EXPECT_NE(Repeated(pattern).result().error.find("direction"), std::string::npos);
  pattern.kind = Pattern::Kind::path;
  EXPECT_NE(Repeated(pattern).result().error.find("two different points"), std::string::npos);
  pattern.count = 0;
  EXPECT_THROW(copies_of(pattern), std::invalid_argument);
}

TEST(Patterns, FilesKeepThem) {
  for (const auto kind :
       {Pattern::Kind::linear, Pattern::Kind::polar, Pattern::Kind::path, Pattern::Kind::mirror}) {
    Pattern pattern;
    pattern.kind = kind;
    pattern.count = 7;
    pattern.step = {0.1, -2, 1e-17};
    pattern.path = {{1, 2, 3}, {0.3, 0, 0}};
    pattern.turns = pattern.keeps = false;
    const Repeated repeated(pattern);
    EXPECT_EQ(parse_scene(scene_text({repeated.scene, {}}), "text").scene, repeated.scene);
  }
}

}  // namespace
}  // namespace sectile::viewer
