// Books along lines that cross each other in a floor, or at its edge: each line is a row, and what
// runs along one of them leads away from the other one. The same comes out with an observer, for
// whom there are no rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "cases.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/leaves.h"

namespace sectile {
namespace {

using test::expect_the_same_for_an_observer;

// Half-planes around a line are numbered in a turn (test::on_square), from the floor up.
constexpr int turn = 192, floor_ahead = 24, floor_behind = floor_ahead + turn / 2;

/// A line in the floor, which is the plane z = 0: the x axis, the y axis, or a diagonal.
struct Line {
  double x, y;
};
constexpr Line x_axis{1, 0}, y_axis{0, 1}, diagonal{1, 1};

void add_leaf_along(const Line& line, const test::Leaf& leaf, PolygonMesh& mesh) {
  const auto o = static_cast<std::uint32_t>(mesh.positions.size());
  for (const int end : {leaf.low, leaf.high}) {
    const Vec3 at{4.0 * end * line.x, 4.0 * end * line.y, 0};
    mesh.positions.push_back(at);
    for (const int half_plane : {leaf.first, leaf.second}) {
      const auto [ahead, up] = test::on_square(half_plane % turn);
      mesh.positions.push_back({at.x - ahead * line.y, at.y + ahead * line.x, up});
    }
  }
  mesh.face_sizes.insert(mesh.face_sizes.end(), 8, 3);
  for (const std::uint32_t k : {0u, 2u, 1u, 3u, 4u, 5u, 0u, 1u, 4u, 0u, 4u, 3u,
                                1u, 2u, 5u, 1u, 5u, 4u, 2u, 0u, 3u, 2u, 3u, 5u})
    mesh.indices.push_back(o + k);
}

// Leaves side by side, which all begin and end elsewhere.
struct Leaves {
  Line line;
  int first, last;  ///< half-planes
  int low, high;
};
Solid book(std::initializer_list<Leaves> all) {
  PolygonMesh mesh;
  for (const Leaves& leaves : all) {
    const int count = (leaves.last - leaves.first) / 2;
    for (int i = 0; i < count; ++i)
      add_leaf_along(leaves.line,
                     {leaves.first + 2 * i, leaves.first + 2 * i + 1, leaves.low - 7 * i % count,
                      leaves.high + 11 * i % count},
                     mesh);
  }
  return Solid::from_mesh(mesh);
}

TEST(CrossingLines, OfBooksAboveAndBelowAFloor) {
  const Solid above_and_below = book({{x_axis, floor_ahead, floor_behind, -1, 1},
                                      {y_axis, floor_behind + 1, floor_ahead + turn, -1, 1}});
  const Solid body = block({-400, -400, -30}, {400, 400, 0});
  expect_the_same_for_an_observer(body, above_and_below);
  expect_the_same_for_an_observer(above_and_below, body);
}

TEST(CrossingLines, OfBooksWithAGapWhereTheyCross) {
  const Solid above_and_below = book({{x_axis, floor_ahead, floor_behind, 60, 61},
                                      {x_axis, floor_ahead + 1, floor_behind, -110, -109},
                                      {y_axis, floor_behind, floor_ahead + turn, -1, 1}});
  expect_the_same_for_an_observer(block({-800, -400, -30}, {800, 400, 0}), above_and_below);
}

// One book has its line in the floor's edge, and the other one stands on the floor and beyond: the
// edge is divided where the floor is.
TEST(CrossingLines, OfBooksAtTheEdgeOfAFloor) {
  const Solid above_and_below = book({{x_axis, floor_ahead, floor_behind, -1, 1},
                                      {y_axis, floor_behind + 1, floor_ahead + turn, -1, 1}});
  const Solid body = block({0, -400, -30}, {400, 400, 0});
  expect_the_same_for_an_observer(body, above_and_below);
  expect_the_same_for_an_observer(above_and_below, body);
}

// A leaf that is half above the floor and half below it ends in the plane through the other line:
// its end is where that line has no leaves.
TEST(CrossingLines, OfWhichOneRunsOnInTheEndOfALeaf) {
  PolygonMesh mesh;
  for (int i = 0; i < 36; ++i) {
    add_leaf_along(
        x_axis,
        {floor_ahead + 2 * i + 1, floor_ahead + 2 * i + 2, -1 - 7 * i % 36, 4 + 11 * i % 36}, mesh);
    add_leaf_along(
        y_axis,
        {floor_ahead + 2 * i + 1, floor_ahead + 2 * i + 2, 100 - 7 * i % 36, 110 + 11 * i % 36},
        mesh);
  }
  add_leaf_along(x_axis, {floor_behind - 21, floor_behind + 6, 0, 3}, mesh);
  const Solid books = Solid::from_mesh(mesh), body = block({-700, -700, 0}, {700, 700, 30});
  expect_the_same_for_an_observer(body, books);
  expect_the_same_for_an_observer(books, body);
}

// Leaves anywhere along two lines, above the floor or below it, some of them flush with it, as long
// as they make a solid.
class RandomBooks {
 public:
  explicit RandomBooks(unsigned seed) : random_(seed) {}

  Solid book() {
    PolygonMesh mesh;
    const std::array<Line, 2> lines{x_axis, below(2) == 0 ? y_axis : diagonal};
    const int first_side = below(2);
    for (int tries = 20; tries > 0; --tries) {
      const int number = below(2), side = below(4) == 0 ? below(2) : (number + first_side) % 2,
                first = floor_ahead + side * turn / 2 + (below(6) == 0 ? 0 : below(turn / 2 - 4)),
                low = below(24) - 18;
      PolygonMesh more = mesh;
      add_leaf_along(lines[static_cast<std::size_t>(number)],
                     {first, first + 1 + below(4), low, std::max(low, 0) + 1 + below(12)}, more);
      if (test::is_accepted(more)) mesh = std::move(more);
    }
    return Solid::from_mesh(mesh);
  }
  Solid body() {
    const double x = below(2) == 0 ? 0 : -200, y = below(2) == 0 ? 0 : -200;
    return below(2) == 0 ? block({x, y, -30}, {200, 200, 0}) : block({x, y, 0}, {200, 200, 30});
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 random_;
};

TEST(CrossingLines, OfLeavesAnywhere) {
  for (unsigned seed = 0; seed < cases(30u); ++seed) {
    SCOPED_TRACE(seed);
    RandomBooks random(seed);
    Solid a = random.body(), b = random.book();
    if (random.below(2) == 0)
      a = boolean(a, random.book(), random.below(2) == 0 ? Operation::unite : Operation::subtract);
    expect_the_same_for_an_observer(a, b);
    expect_the_same_for_an_observer(b, a);
  }
}

}  // namespace
}  // namespace sectile
