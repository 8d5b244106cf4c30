// What Booleans of books leave out matters nowhere: the same comes out with an observer, for whom
// nothing is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "boolean/components/free_point.h"
#include "boolean/loading/load.h"
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
// nothing of it but its faces is known to be off them by the lines that it is on.
struct TetrahedronAtLines {
  Solid a, b;

  TetrahedronAtLines() {
    const Vec3 o{0, 0, 0}, x{1024, 0, 0}, y{0, 1024, 0}, z{0, 0, 1024};
    const Vec3 left{-1, 0, 0}, front{0, -1, 0}, down{0, 0, -1}, out{1, 1, 1};
    PolygonMesh of_a, of_b;
    add_tetrahedron({o, x, y, z}, of_a);
    for (const double far : {-8192.0, 8192.0})  // so that all is near its box
      add_tetrahedron(
          {{{far, far, far}, {far + 1, far, far}, {far, far + 1, far}, {far, far, far + 1}}}, of_a);
    for (const Spine& spine : {Spine{o, x, front, down},
                               {o, y, down, left},
                               {o, z, left, front},
                               {x, y, out, down},
                               {y, z, out, left},
                               {z, x, out, front}})
      add_walls(spine, 1100, 1400, 2, 40, of_b);
    add_crowd_elsewhere(0, of_a);
    add_crowd_elsewhere(2, of_b);
    a = repair(of_a);
    b = repair(of_b);
  }
};

TEST(CrowdedBooks, AtTheLinesOfATetrahedronLeaveItAsItIs) {
  const TetrahedronAtLines given;
  expect_apart(given.a, given.b);
}

TEST(CrowdedBooks, AtTheLinesOfATetrahedronLeavePointsWithinItsFaces) {
  const TetrahedronAtLines given;
  const BooleanOptions options;
  Workspace w(options);
  FacePairs pairs;
  const Operation unite[] = {Operation::unite};
  load(w, given.a.data()->in_one_block(), given.b.data()->in_one_block(), pairs, {unite});
  ASSERT_FALSE(w.crowded_lines.empty());
  const Contacts contacts = reduce(w, pairs);
  const Patch& patch = w.patch[Operand::a];
  const auto is_of_tetrahedron = [&](FaceId f) {
    bool all = true;
    for_each_in_face(patch.brep, f, [&](HalfEdgeId h) {
      const Vec3 p = w.geometry.position(patch.brep.point_of(patch.brep.from(h)));
      all &= p.x + p.y + p.z == 1024;
    });
    return all;
  };
  const auto faces = patch.brep.faces();
  const auto face = std::ranges::find_if(faces, is_of_tetrahedron);
  ASSERT_NE(face, faces.end());
  FreePoints free(w, contacts, Operand::a);
  const std::vector<PointId> found = free.on_shell_of(*face);
  ASSERT_EQ(found.size(), 1u);
  const Vec3 p = w.geometry.position(found[0]);
  EXPECT_GT(std::min({p.x, p.y, p.z}), 0);
  EXPECT_EQ(w.tests().side(found[0], patch.plane(*face)), Sign::zero);
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

// Leaves farther up, so that very many edges of both solids run along the line.
void add_crowd_above(int first, PolygonMesh& mesh) {
  for (int i = 0; i < 45; ++i)
    test::add_leaf({first + 4 * i, first + 4 * i + 1, 100 + i, 300 - i}, false, mesh);
}

// Two quarters side by side have one face on both sides of the line, which lies within it as far as
// both reach. The edge of a leaf beyond that face says nothing of what is within the quarters.
TEST(CrowdedBooks, WithAFaceOnBothSidesOfTheLineAreWhatTheyAreForAnObserver) {
  for (const int turn : {0, 96})
    for (const int leaf : {20, 94, 120}) {
      SCOPED_TRACE(turn);
      SCOPED_TRACE(leaf);
      PolygonMesh of_a, quarter, other, above;
      test::add_leaf({(turn + leaf) % 192, (turn + leaf + 4) % 192, 6, 9}, false, of_a);
      add_crowd_above(0, of_a);
      test::add_leaf({turn, (turn + 48) % 192, 0, 10}, false, quarter);
      test::add_leaf({(turn + 48) % 192, (turn + 96) % 192, 5, 20}, false, other);
      add_crowd_above(2, above);
      test::add_leaf({(turn + 140) % 192, (turn + 144) % 192, 5, 13}, false, above);
      const Solid quarters =
          boolean(Solid::from_mesh(quarter), Solid::from_mesh(other), Operation::unite);
      const Solid joined = Solid::from_mesh(quarters.to_mesh());  // with flat faces joined
      const Solid b = boolean(joined, Solid::from_mesh(above), Operation::unite);
      expect_the_same_for_an_observer(Solid::from_mesh(of_a), b);
      expect_the_same_for_an_observer(b, Solid::from_mesh(of_a));
    }
}

// A leaf for each part of a turn, that reaches to the next one at most; some have another one above
// them.
Solid random_chain(std::mt19937& random, int first, int lows, bool sheared) {
  constexpr int turn = 192, step = 4;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  PolygonMesh mesh;
  for (int at = first; at < first + turn; at += step) {
    const int end = at + 1 + below(step - 1), low = below(lows), high = low + 1 + below(60);
    test::add_leaf({at % turn, end % turn, low, high}, sheared, mesh);
    const int next = high + 1 + below(5);
    if (below(3) == 0)
      test::add_leaf({at % turn, end % turn, next, next + 1 + below(60)}, sheared, mesh);
  }
  return Solid::from_mesh(mesh);
}

// Each leaf of one overlaps the next one of the other, all around the line.
TEST(CrowdedBooks, OfLeavesThatOverlapAllAroundAreWhatTheyAreForAnObserver) {
  for (const int lows : {40, 3, 1})
    for (unsigned seed = 0; seed < cases(2u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_chain(random, 0, lows, seed % 2 == 1);
      expect_the_same_for_an_observer(a, random_chain(random, 2, lows, seed % 2 == 1));
    }
}

// Nothing but the sets' own laws, and volumes: no other way of the Boolean is asked.
TEST(CrowdedBooks, OfLeavesThatOverlapAllAroundObeyTheLawsOfSets) {
  for (const int lows : {40, 1})
    for (unsigned seed = 0; seed < cases(3u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_chain(random, 0, lows, false),
                  b = random_chain(random, 1, lows, false),
                  both = boolean(a, b, Operation::intersect), any = boolean(a, b, Operation::unite),
                  rest = boolean(a, b, Operation::subtract);
      EXPECT_NEAR(any.volume() + both.volume(), a.volume() + b.volume(), 1e-9 * any.volume());
      EXPECT_NEAR(rest.volume() + both.volume(), a.volume(), 1e-9 * a.volume());
      EXPECT_TRUE(boolean(rest, both, Operation::unite) == a);
      EXPECT_TRUE(boolean(any, rest, Operation::subtract) == b);
      EXPECT_TRUE(boolean(rest, b, Operation::intersect).is_empty());
      for (const Solid& made : {both, any, rest}) EXPECT_TRUE(validate(made).empty());
    }
}

}  // namespace
}  // namespace sectile
