// Moves are exact: they commute with Booleans, whatever the matrix, and never make or lose a face.
#include "storage/moved_solid.h"

#include <gtest/gtest.h>

#include <random>

#include "sectile/sectile.h"

namespace sectile {
namespace {

void expect_legal(const Solid& solid) {
  for (const Violation& v : validate(solid)) ADD_FAILURE() << v.what;
}

Solid tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return Solid::from_mesh({{a, b, c, d}, {3, 3, 3, 3}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}});
}

class Matrices {
 public:
  explicit Matrices(unsigned seed) : random_(seed) {}

  Transform rotation() {
    return Transform::rotation_degrees({number(), number(), 0.1 + std::abs(number())},
                                       360 * number());
  }
  Transform shear() { return {{1, number(), 0, 0, 0, 1, 0, 0, number(), 0, 1, 0}}; }
  Transform mirror() { return rotation() * Transform::scaling({1, -1, 1}); }
  Transform anything() {
    for (;;) {
      Transform t;
      for (double& m : t.m) m = 3 * number();
      try {
        transformed(block({0, 0, 0}, {1, 1, 1}), t);
        return t;
      } catch (const std::invalid_argument&) {
        continue;
      }
    }
  }
  Transform extreme() {
    const auto size = [&] { return std::pow(10.0, 200 * number()); };
    return Transform::scaling({size(), size(), size()}) * shear() * rotation();
  }
  Transform any() {
    switch (random_() % 6) {
      case 0:
        return rotation();
      case 1:
        return shear();
      case 2:
        return mirror();
      case 3:
        return extreme();
      case 4:
        return {{3, -4, 0, 0, 4, 3, 0, 0, 0, 0, 5, 0}};
      default:
        return anything();
    }
  }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

 private:
  std::mt19937 random_;
};

struct Pair {
  const char* name;
  Solid a, b;
};

std::vector<Pair> pairs() {
  const Solid cube = block({0, 0, 0}, {4, 4, 4});
  const Solid hook = extrude({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {1, 5}, {0, 4}}, {}}, 3);
  const Solid tip = tetrahedron({-1, -2, 1}, {7, 1, 2}, {1, 6, 3}, {2, 1, 9});
  const Solid cut = boolean(cube, tip, Operation::subtract);
  const Solid touching = boolean(cube, block({4, 4, 0}, {6, 6, 4}), Operation::unite);
  return {
      {"flush blocks", cube, block({4, 1, 1}, {8, 3, 3})},
      {"overlapping blocks in one plane", cube, block({2, 0, 2}, {6, 4, 4})},
      {"pierced", cube, block({1, 1, -1}, {2, 2, 5})},
      {"oblique", cube, tip},
      {"flat edges", hook, block({1, -1, 1}, {3, 2, 4})},
      {"implicit points on flush faces", cut,
       boolean(block({4, 0, 0}, {8, 4, 4}), tip, Operation::subtract)},
      {"implicit points met again", cut, tip},
      {"edges that touch", touching, block({3, 3, 1}, {5, 5, 2})},
      {"by coefficients", split(cube, {1, 2, 3, -11}).first, split(cube, {1, 2, 3, -11}).second}};
}

TEST(MovedSolid, MovesCommuteWithBooleans) {
  Matrices matrices(1);
  for (const Pair& pair : pairs())
    for (int i = 0; i < 8; ++i) {
      const Transform t = matrices.any();
      const Solid a = transformed(pair.a, t), b = transformed(pair.b, t);
      for (const Operation o : {Operation::unite, Operation::intersect, Operation::subtract}) {
        SCOPED_TRACE(pair.name);
        const Solid plain = boolean(pair.a, pair.b, o);
        const Solid before = boolean(a, b, o), after = transformed(plain, t);
        expect_legal(before);
        expect_legal(after);
        EXPECT_TRUE(before == after);
        EXPECT_EQ(before.counts().faces, plain.counts().faces);
        EXPECT_EQ(before.counts().edges, plain.counts().edges);
        EXPECT_EQ(before.counts().shells, plain.counts().shells);
      }
    }
}

TEST(MovedSolid, ResultsMoveOnAndOn) {
  Matrices matrices(2);
  for (const Pair& pair : pairs()) {
    SCOPED_TRACE(pair.name);
    const Transform s = matrices.any(), t = matrices.any();
    const Solid both = boolean(pair.a, pair.b, Operation::unite);
    const Solid moved =
        transformed(boolean(transformed(pair.a, s), transformed(pair.b, s), Operation::unite), t);
    EXPECT_TRUE(moved == transformed(transformed(both, s), t));
    // Of points in three frames.
    const Solid far = boolean(moved, transformed(pair.a, t), Operation::subtract);
    expect_legal(far);
    expect_legal(transformed(far, s));
    EXPECT_EQ(transformed(far, s).counts().faces, far.counts().faces);
  }
}

TEST(MovedSolid, ABoxWithFlatEdgesCutByATetrahedronAndMappedExactly) {
  const PolygonMesh box{
      {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {0, 0, 2}, {3, 0, 2}, {3, 2, 2}, {0, 2, 2}},
      std::vector<std::uint32_t>(12, 3),
      {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
       1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7}};
  const PolygonMesh tip{{{4, -1, 1}, {-2, -2, 4}, {3, -2, 4}, {0, 2, 3}},
                        {3, 3, 3, 3},
                        {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}};
  Solid b;
  try {
    b = Solid::from_mesh(tip);
  } catch (const InvalidSolid&) {
    PolygonMesh turned = tip;
    std::reverse(turned.indices.begin(), turned.indices.end());
    b = Solid::from_mesh(turned);
  }
  const Solid a = Solid::from_mesh(box);
  const Transform t{{3, -4, 0, 0, 4, 3, 0, 0, 0, 0, 5, 0}};
  const Solid image = transformed(boolean(a, b, Operation::intersect), t);
  expect_legal(image);
  EXPECT_TRUE(image == boolean(transformed(a, t), transformed(b, t), Operation::intersect));
}

TEST(MovedSolid, RandomImagesOfResultsAreLegal) {
  Matrices matrices(3);
  std::vector<Solid> results;
  for (const Pair& pair : pairs())
    for (const Operation o : {Operation::unite, Operation::intersect, Operation::subtract})
      if (const Solid result = boolean(pair.a, pair.b, o); !result.is_empty())
        results.push_back(result);
  for (int i = 0; i < 20; ++i)
    for (const Solid& solid : results) {
      const Solid image = transformed(solid, matrices.any());
      expect_legal(image);
      EXPECT_EQ(image.counts().faces, solid.counts().faces);
    }
}

TEST(MovedSolid, MovesAreMultipliedExactly) {
  const Solid solid = pairs()[3].a;
  const Transform there{{1, 0.1, 0, 0.3, 0, 1, 0, 0, 0, 0, 1, -0.7}};
  const Transform back{{1, -0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  const Solid once =
      transformed(transformed(solid, Transform{{1, 0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}), back);
  EXPECT_EQ(once.data(), solid.data());
  // A move back of a result leads to coordinates in doubles again.
  const Solid hole = block({1, 1, -1}, {2, 2, 5});
  const Solid moved =
      boolean(transformed(solid, there), transformed(hole, there), Operation::subtract);
  ASSERT_FALSE(moved.data()->geometry().moved.empty());
  const Solid home = transformed(transformed(moved, Transform::translation({-0.3, 0, 0.7})), back);
  EXPECT_TRUE(home.data()->geometry().moved.empty());
  EXPECT_TRUE(home == boolean(solid, hole, Operation::subtract));
}

TEST(MovedSolid, CoordinatesBeyondTheDoubles) {
  const Solid solid = pairs()[5].a;
  const Transform large = Transform::scaling({1e200, 1e200, 1e200});
  const Solid far = transformed(transformed(solid, large), large);
  expect_legal(far);
  EXPECT_EQ(far.volume(), std::numeric_limits<double>::infinity());
  const Transform small = Transform::scaling({1e-200, 1e-200, 1e-200});
  const Solid tiny = transformed(transformed(solid, small), small);
  expect_legal(tiny);
  EXPECT_EQ(tiny.volume(), 0);
  EXPECT_FALSE(tiny.is_empty());
  const Transform along = Transform::scaling({1e200, 1e-200, 1});
  const Solid needle = transformed(transformed(solid, along), along);
  expect_legal(needle);
  EXPECT_NEAR(needle.volume(), solid.volume(), 1e-12 * solid.volume());
}

TEST(MovedSolid, AMoveCopiesNothing) {
  const Solid ball = sphere(1, 64, 32);
  const Solid moved = transformed(ball, Transform::rotation_degrees({1, 2, 3}, 25));
  const auto &from = ball.data()->slots(), &to = moved.data()->slots();
  ASSERT_EQ(from.size(), to.size());
  for (std::size_t s = 0; s < from.size(); ++s)
    EXPECT_EQ(&from[s].block->brep(), &to[s].block->brep());
}

// A tooth is what a half of a slab has beyond its own image under a turn. Its two sides lie in a
// plane and in the image of that plane, so that each tooth is flush with the next one.
TEST(MovedSolid, AGearOfFortyTurnedTeeth) {
  const Solid half = block({-10, 0, 0}, {10, 10, 2});
  const Transform turn = Transform::rotation_degrees({0, 0, 1}, 9);
  const Solid tooth = boolean(boolean(half, transformed(half, turn), Operation::subtract),
                              block({0, -1, 0}, {10, 10, 2}), Operation::intersect);
  expect_legal(tooth);
  Solid gear, turned = tooth;
  for (int i = 0; i < 40; ++i) {
    if (i > 0 && i < 39) {
      EXPECT_TRUE(boolean(gear, turned, Operation::intersect).is_empty());
      // A tooth is a sector with a fin where the turned block does not reach. Both faces between
      // the sectors vanish, and the inner one of the fin; tops and bottoms become one face each.
      const std::size_t apart = gear.counts().faces + turned.counts().faces;
      const Solid both = boolean(gear, turned, Operation::unite);
      EXPECT_EQ(both.counts().shells, 1u);
      EXPECT_EQ(both.counts().faces, apart - 5);
    }
    gear = boolean(gear, turned, Operation::unite);
    turned = transformed(turned, turn);
  }
  expect_legal(gear);
  EXPECT_NEAR(gear.volume(), 40 * tooth.volume(), 1e-9);
}

}  // namespace
}  // namespace sectile
