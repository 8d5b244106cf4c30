// Books of both solids along lines that cross each other: pairs of walls that meet in the crossing
// only are left out. The same comes out with an observer, for whom nothing is left out, and as
// cells of an arrangement.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "boolean/loading/load.h"
#include "cases.h"
#include "prism.h"
#include "sectile/arrangement.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"
#include "unit/leaves.h"

namespace sectile {
namespace {

using test::expect_laws_of_sets;
using test::expect_the_same_for_an_observer;

constexpr int turn = 192;  // half-planes around a line (test::on_square)

/// A line through the origin; half-planes are counted from `ahead` over `up`.
struct Line {
  Vec3 along, ahead, up;
};
constexpr Line x_axis{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, y_axis{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    z_axis{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, diagonal{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}},
    slanted{{1, 2, 1}, {2, -1, 0}, {0, 1, 2}};
constexpr int up = 24, down = up + turn / 2;  // half-planes: up to `down` are above

/// A wall between two half-planes, from one place of its line to another one. Its ends lean over.
struct Wall {
  int first, second;
  double low, high, lean = 0;
};

bool is_right_handed(const Line& l) {
  return l.along.x * (l.ahead.y * l.up.z - l.ahead.z * l.up.y) +
             l.along.y * (l.ahead.z * l.up.x - l.ahead.x * l.up.z) +
             l.along.z * (l.ahead.x * l.up.y - l.ahead.y * l.up.x) >
         0;
}

void add_wall(const Line& line, const Wall& wall, PolygonMesh& mesh) {
  const auto o = static_cast<std::uint32_t>(mesh.positions.size());
  const auto at = [&](double along, double ahead, double above) {
    const auto [l, a, u] = line;
    return Vec3{along * l.x + ahead * a.x + above * u.x, along * l.y + ahead * a.y + above * u.y,
                along * l.z + ahead * a.z + above * u.z};
  };
  for (const double end : {wall.low, wall.high}) {
    mesh.positions.push_back(at(end, 0, 0));
    for (const int half_plane : {wall.first, wall.second}) {
      const auto [ahead, above] = test::on_square(half_plane % turn);
      mesh.positions.push_back(at(end + wall.lean, ahead, above));
    }
  }
  const bool turned = !is_right_handed(line);
  for (auto [a, b, c] : test::prism_triangles) {
    if (turned) std::swap(b, c);
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {o + a, o + b, o + c});
  }
}

// Side by side from one half-plane on; all begin and end elsewhere on both sides of the crossing.
constexpr int many = 45;
void add_walls(const Line& line, int first, PolygonMesh& mesh, double lean = 0) {
  for (int i = 0; i < many; ++i)
    add_wall(line, {first + 2 * i, first + 2 * i + 1, -20.0 - i, 20.0 + 7 * i % many, lean}, mesh);
}
Solid book(const Line& line, int first, double lean = 0) {
  PolygonMesh mesh;
  add_walls(line, first, mesh, lean);
  return Solid::from_mesh(mesh);
}

std::size_t count_pairs(const Solid& a, const Solid& b, bool all = false) {
  const BooleanOptions options;
  Workspace w(options);
  FacePairs pairs;
  const Operation unite[] = {Operation::unite};
  load(w, a.data()->in_one_block(), b.data()->in_one_block(), pairs, {unite, false, all});
  return pairs.size();
}

void expect_what_cells_are(const Solid& a, const Solid& b) {
  Solid only_a, only_b, both;
  for (const SolidCell& cell : cells(std::vector<Solid>{a, b}))
    (cell.operands.size() == 2 ? both : cell.operands[0] == 0 ? only_a : only_b) = cell.solid;
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == both);
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == only_a);
  EXPECT_TRUE(boolean(b, a, Operation::subtract) == only_b);
}

TEST(BooksAtACrossing, OnBothSidesOfTheirPlaneAreInNoPair) {
  for (const Line& other : {y_axis, diagonal})
    for (const double lean : {0.0, 3.0}) {
      const Solid a = book(x_axis, up + 2, lean), b = book(other, down + 2, lean);
      EXPECT_EQ(count_pairs(a, b), 0u);
      EXPECT_GT(count_pairs(a, b, true), std::size_t(many * many));
      EXPECT_EQ(boolean(a, b, Operation::unite).counts().shells, std::size_t(2 * many));
      expect_the_same_for_an_observer(a, b);
    }
}

// Walls of one book begin at the crossing: they meet those of the other one that lean their way.
TEST(BooksAtACrossing, OnOneSideOfTheirPlaneAreInPairsIfTheirDirectionsMeet) {
  PolygonMesh from_crossing;
  for (int i = 0; i < many; ++i)
    add_wall(y_axis, {up + 2 + 2 * i, up + 3 + 2 * i, 0, 90.0 + i}, from_crossing);
  const Solid a = book(x_axis, up + 2), b = Solid::from_mesh(from_crossing);
  EXPECT_LT(3 * count_pairs(a, b), 2 * count_pairs(a, b, true));
  expect_laws_of_sets(a, b);
}

TEST(BooksAtACrossing, ThatCrossEachOtherAreCut) {
  const Solid a = book(x_axis, up + 2), b = book(y_axis, up + 2);
  EXPECT_GE(count_pairs(a, b), std::size_t(many * many));
  expect_what_cells_are(a, b);
}

// By less than doubles tell around the lines, so that all walls of one book cut the other one's.
TEST(BooksAtACrossing, WhoseLinesMissEachOtherByAHairAreCut) {
  const Solid a = book(x_axis, up + 2);
  for (const double above : {0x1p-60, -0x1p-60}) {
    SCOPED_TRACE(above);
    const Solid b = transformed(book(y_axis, down + 2), Transform::translation({0, 0, above}));
    EXPECT_EQ(boolean(a, b, Operation::intersect).is_empty(), above < 0);
    expect_what_cells_are(a, b);
  }
}

// One wall of each begins where the lines cross. Nothing else of one solid is at one place there.
TEST(BooksAtACrossing, OfWhichWallsBeginThereTouchEachOther) {
  PolygonMesh of_a, of_b;
  add_walls(x_axis, up + 4, of_a, 3);
  add_walls(y_axis, down + 4, of_b, 3);
  add_wall(x_axis, {up + 2, up + 3, 0, 90, 3}, of_a);
  add_wall(y_axis, {down + 2, down + 3, 0, 90, 3}, of_b);
  const Solid a = Solid::from_mesh(of_a), b = Solid::from_mesh(of_b);
  EXPECT_FALSE(a.data()->touches_itself());
  EXPECT_FALSE(b.data()->touches_itself());
  EXPECT_TRUE(boolean(a, b, Operation::unite).data()->touches_itself());
  expect_the_same_for_an_observer(a, b);
}

// Three lines through one point, with walls of both solids along each of them, moved to where
// coordinates are no doubles.
TEST(BooksAtACrossing, OfThreeLinesAreWhatTheyAreForAnObserver) {
  PolygonMesh of_a, of_b;
  add_walls(x_axis, up + 2, of_a);
  add_walls(y_axis, down + 2, of_b);
  for (int i = 0; i < many; ++i) {
    add_wall(z_axis, {48 + i, 49 + i, 40.0 + i, 90.0 + i}, i % 2 == 0 ? of_a : of_b);
    add_wall(z_axis, {48 + i, 49 + i, -90.0 - i, -40.0 - i}, i % 2 == 0 ? of_b : of_a);
  }
  Solid a = Solid::from_mesh(of_a), b = Solid::from_mesh(of_b);
  expect_the_same_for_an_observer(a, b);
  const Transform move =
      Transform::translation({0.3, 0.7, 0.1}) * Transform::rotation_degrees({1, 2, 3}, 20);
  a = transformed(a, move);
  b = transformed(b, move);
  expect_the_same_for_an_observer(a, b);
  const Solid body = transformed(block({-100, -100, -100}, {100, 100, 0}), move);
  expect_the_same_for_an_observer(boolean(a, body, Operation::unite), b);
}

// Walls anywhere along a few lines, some of which begin or end at the crossing, as long as they
// make a solid.
class RandomBooks {
 public:
  explicit RandomBooks(unsigned seed) : random_(seed) {
    std::array<Line, 5> all{x_axis, y_axis, z_axis, diagonal, slanted};
    std::ranges::shuffle(all, random_);
    std::copy_n(all.begin(), 2 + below(2), std::back_inserter(lines_));
  }

  Solid book(std::size_t most) {
    PolygonMesh mesh;
    const int side = below(2) * turn / 2;
    for (int tries = 30; tries > 0; --tries) {
      const std::size_t line = below(3) == 0 ? static_cast<std::size_t>(below(2)) : most;
      const int first = up + (below(4) == 0 ? turn / 2 - side : side) + below(turn / 2 - 4),
                kind = below(5);
      const double low = kind == 0 ? 0 : -1.0 - below(24),
                   high = kind == 1 ? 0 : std::max(low, 0.0) + 1 + below(24);
      PolygonMesh more = mesh;
      add_wall(lines_[line], {first, first + 1 + below(4), low, high, below(5) - 2.0}, more);
      if (test::is_accepted(more)) mesh = std::move(more);
    }
    return Solid::from_mesh(mesh);
  }
  Solid body() {
    const double x = below(2) == 0 ? 0 : -20, y = below(2) == 0 ? 0 : -20;
    return below(2) == 0 ? block({x, y, -30}, {20, 20, 0}) : block({x, y, 0}, {20, 20, 30});
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 random_;
  std::vector<Line> lines_;
};

TEST(BooksAtACrossing, OfWallsAnywhereAreWhatTheirCellsAre) {
  for (unsigned seed = 0; seed < cases(20u); ++seed) {
    SCOPED_TRACE(seed);
    RandomBooks random(seed);
    Solid a = random.book(0);
    const Solid b = random.book(1);
    if (random.below(3) == 0)
      a = boolean(a, random.body(), random.below(2) == 0 ? Operation::unite : Operation::subtract);
    expect_the_same_for_an_observer(a, b);
    expect_what_cells_are(a, b);
  }
}

}  // namespace
}  // namespace sectile
