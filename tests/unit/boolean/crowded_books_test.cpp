// What Booleans of books leave out matters nowhere: the same comes out with an observer, for whom
// nothing is left out.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "cases.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"
#include "unit/leaves.h"

namespace sectile {
namespace {

// Leaves anywhere, some wide, some of them slits in others, as long as they make a solid; they
// begin in one of so many places.
Solid random_book(std::mt19937& random, int count, int lows, bool sheared) {
  constexpr int turn = 192;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  PolygonMesh mesh;
  for (int made = 0, tries = 0; made < count && tries < 6 * count; ++tries) {
    const int first = below(turn), width = tries % 17 == 0 ? 20 + below(75) : 1 + below(4),
              low = below(lows);
    PolygonMesh more = mesh;
    test::add_leaf({first, (first + width) % turn, low, low + 1 + below(60), below(12) == 0},
                   sheared, more);
    if (!test::is_accepted(more)) continue;
    mesh = std::move(more);
    ++made;
  }
  return Solid::from_mesh(mesh);
}

struct Listener : Observer {
  void phase_done(Phase, const std::vector<TraceEvent>&) override {}
};

void expect_the_same_for_an_observer(const Solid& a, const Solid& b) {
  Listener listener;
  BooleanOptions observed;
  observed.observer = &listener;
  for (const Operation op : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Solid result = boolean(a, b, op), all = boolean(a, b, op, observed);
    EXPECT_TRUE(result == all);
    EXPECT_TRUE(validate(result).empty());
    EXPECT_TRUE(boolean(result, b, Operation::subtract) == boolean(all, b, Operation::subtract));
  }
}

void add_tetrahedron(const std::array<Vec3, 4>& corners, PolygonMesh& mesh) {
  const auto o = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
  for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
    mesh.indices.push_back(o + k);
}

// Part of a line, and two directions that leave it.
struct Spine {
  Vec3 from, to, first, last;
};

// Walls along a spine, between parts low and high of 1024, which all end elsewhere. Every second
// pair of directions is for other walls.
void add_walls(const Spine& spine, int low, int high, int first_direction, int count,
               PolygonMesh& mesh) {
  const auto between = [](const Vec3& p, const Vec3& q, double t) {
    return Vec3{p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t};
  };
  const Vec3 middle = between(spine.from, spine.to, (low + high) / 2048.0);
  for (int i = 0; i < count; ++i) {
    const auto beside = [&](int k) {
      const Vec3 way = between(spine.first, spine.last, k / 256.0);
      return Vec3{middle.x + 8 * way.x, middle.y + 8 * way.y, middle.z + 8 * way.z};
    };
    const int direction = first_direction + 4 * i;
    add_tetrahedron({between(spine.from, spine.to, (low + i) / 1024.0),
                     between(spine.from, spine.to, (high - i) / 1024.0), beside(direction),
                     beside(direction + 1)},
                    mesh);
  }
}

// A crowd of both solids, so that crowded lines are looked for everywhere.
void add_crowd_elsewhere(int first_direction, PolygonMesh& mesh) {
  add_walls({{4096, 0, 0}, {4096, 0, 1024}, {-1, 0, 0}, {0, -1, 0}}, 100, 900, first_direction, 60,
            mesh);
}

// Walls side by side, none of which reaches to the next one.
Solid book_of_walls(int first_direction, int count, bool of_one_length) {
  PolygonMesh mesh;
  if (count > 3) add_crowd_elsewhere(first_direction == 0 ? 0 : 2, mesh);
  for (int i = 0; i < count; ++i) {
    const int direction = first_direction + 2 * i, end = of_one_length ? 0 : i;
    test::add_leaf({direction, direction + 1, end % 7, 200 - end}, false, mesh);
  }
  return repair(mesh);  // knows where walls touch
}

void expect_apart(const Solid& a, const Solid& b) {
  EXPECT_EQ(boolean(a, b, Operation::subtract), a);
  EXPECT_EQ(boolean(b, a, Operation::subtract), b);
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  EXPECT_DOUBLE_EQ(boolean(a, b, Operation::unite).volume(), a.volume() + b.volume());
}

// Of the wedges between walls of one book, the widest one holds the other book. Three walls are a
// crowd in builds with small crowds.
TEST(CrowdedBooks, AreNotCutByBooksBesideThem) {
  for (const int count : {3, 45})
    for (const bool of_one_length : {true, false}) {
      SCOPED_TRACE(count);
      SCOPED_TRACE(of_one_length);
      expect_apart(book_of_walls(0, count, of_one_length),
                   book_of_walls(100, count, of_one_length));
    }
}

// The walls of one solid begin in the lines of all edges of a tetrahedron, beyond its corners:
// nothing of it is known to be off them by the lines that it is on.
TEST(CrowdedBooks, AtTheLinesOfATetrahedronLeaveItAsItIs) {
  const Vec3 o{0, 0, 0}, x{1024, 0, 0}, y{0, 1024, 0}, z{0, 0, 1024};
  const Vec3 left{-1, 0, 0}, front{0, -1, 0}, down{0, 0, -1}, out{1, 1, 1};
  PolygonMesh a, b;
  add_tetrahedron({o, x, y, z}, a);
  for (const double far : {-8192.0, 8192.0})  // so that all is near its box
    add_tetrahedron(
        {{{far, far, far}, {far + 1, far, far}, {far, far + 1, far}, {far, far, far + 1}}}, a);
  for (const Spine& spine : {Spine{o, x, front, down},
                             {o, y, down, left},
                             {o, z, left, front},
                             {x, y, out, down},
                             {y, z, out, left},
                             {z, x, out, front}})
    add_walls(spine, 1100, 1400, 2, 40, b);
  add_crowd_elsewhere(0, a);
  add_crowd_elsewhere(2, b);
  expect_apart(repair(a), repair(b));
}

TEST(CrowdedBooks, AreWhatTheyAreForAnObserver) {
  for (const int lows : {40, 3, 1})
    for (unsigned seed = 0; seed < cases(2u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_book(random, 45, lows, seed % 2 == 1);
      expect_the_same_for_an_observer(a, random_book(random, 45, lows, seed % 2 == 1));
    }
}

}  // namespace
}  // namespace sectile
