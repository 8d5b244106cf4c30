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
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"
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

using test::expect_the_same_for_an_observer;
using test::Listener;

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

void expect_the_same_areas(const SurfacePart& p, const SurfacePart& q) {
  EXPECT_NEAR(p.area, q.area, 1e-9 * (1 + q.area));
}

void expect_the_same_parts_for_an_observer(const Solid& a, const Solid& b) {
  Listener listener;
  BooleanOptions observed;
  observed.observer = &listener;
  const EightWay parts = classify(a, b), all = classify(a, b, observed);
  expect_the_same_areas(parts.a_in_b, all.a_in_b);
  expect_the_same_areas(parts.a_out_b, all.a_out_b);
  expect_the_same_areas(parts.a_on_b_plus, all.a_on_b_plus);
  expect_the_same_areas(parts.a_on_b_minus, all.a_on_b_minus);
  expect_the_same_areas(parts.b_in_a, all.b_in_a);
  expect_the_same_areas(parts.b_out_a, all.b_out_a);
  expect_the_same_areas(parts.b_on_a_plus, all.b_on_a_plus);
  expect_the_same_areas(parts.b_on_a_minus, all.b_on_a_minus);
  for (const HalfSpace& half_space : {HalfSpace{1, 0, 0, 0}, HalfSpace{-1, 2, 0, 0}}) {
    const auto [above, below] = split(b, half_space);
    const auto [all_above, all_below] = split(b, half_space, observed);
    EXPECT_TRUE(above == all_above);
    EXPECT_TRUE(below == all_below);
    EXPECT_TRUE(validate(above).empty());
    EXPECT_TRUE(validate(below).empty());
  }
}

// Half a turn of material, with the line in its floor.
Solid floor_from(int first, int low, int high) {
  Solid floor;
  for (const int quarter : {first, first + 48}) {
    PolygonMesh mesh;
    test::add_leaf({quarter % 192, (quarter + 48) % 192, low, high}, false, mesh);
    floor = boolean(floor, Solid::from_mesh(mesh), Operation::unite);
  }
  return Solid::from_mesh(floor.to_mesh());  // with flat faces joined
}

// Leaves side by side, from the half-plane `first` on, which all end elsewhere.
Solid leaves_from(int first, int count, int low, int high) {
  PolygonMesh mesh;
  for (int i = 0; i < count; ++i)
    test::add_leaf({(first + 2 * i) % 192, (first + 2 * i + 1) % 192, low + 7 * i % count,
                    high + 11 * i % count},
                   false, mesh);
  return Solid::from_mesh(mesh);
}

// Floors and blocks with the line in their faces, from which leaves are taken, or on which they
// stand; and farther up so many leaves of another solid that the line is crowded.
class RandomFloors {
 public:
  explicit RandomFloors(unsigned seed) : random_(seed) {}

  Solid solid(int first_above) {
    Solid all = below(4) == 0 ? leaves() : floor();
    for (int more = 1 + below(3); more > 0; --more) {
      const Solid next = boolean(all, below(3) == 0 ? floor() : leaves(),
                                 below(2) == 0 ? Operation::unite : Operation::subtract);
      if (!next.is_empty()) all = next;
    }
    return boolean(all, leaves_from(first_above, 36, 200, 240), Operation::unite);
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Solid floor() {
    const int low = below(6) - 4, high = low + 2 + below(8);
    if (below(2) == 0) return floor_from(24 * below(8), low, high);
    const double y = below(2) == 0 ? 0 : -20;
    return block({-20.0 - below(9), y, 16.0 * low}, {20.0 + below(9), y + 20, 16.0 * high});
  }
  Solid leaves() {
    PolygonMesh mesh;
    const int count = 3 + below(12), step = 192 / (count + below(12));
    for (int i = 0; i < count && i * step + step < 192; ++i) {
      const int low = below(6), width = 1 + below(std::min(step - 1, 90));
      test::add_leaf({i * step, (i * step + width) % 192, low, low + 1 + below(6)}, false, mesh);
    }
    return Solid::from_mesh(mesh);
  }

  std::mt19937 random_;
};

TEST(CrowdedBooks, WithFloorsAreWhatTheyAreForAnObserver) {
  for (unsigned seed = 0; seed < cases(12u); ++seed) {
    SCOPED_TRACE(seed);
    RandomFloors floors(seed);
    const Solid a = floors.solid(0), b = floors.solid(1);
    expect_the_same_for_an_observer(a, b);
    expect_the_same_for_an_observer(b, a);
    expect_the_same_parts_for_an_observer(a, b);
  }
}

Solid leaves(std::initializer_list<test::Leaf> all) {
  PolygonMesh mesh;
  for (const test::Leaf& leaf : all) test::add_leaf(leaf, false, mesh);
  return Solid::from_mesh(mesh);
}

// So that the line is crowded.
Solid with_leaves_above(const Solid& solid, int first) {
  return boolean(solid, leaves_from(first, 60, 200, 280), Operation::unite);
}

// A prism touches a floor in the line; the plane cuts both, and an edge crosses the line where no
// leaf ends.
TEST(CrowdedBooks, OfWhichAnEdgeCrossesTheLineInAFloorAreSplitThere) {
  const Solid grooved = boolean(floor_from(72, -3, 10),
                                leaves({{124, 127, 0, 1}, {134, 137, 0, 4}}), Operation::subtract);
  const Solid standing = boolean(block({0, -8, -32}, {1, 17, 16}),
                                 leaves({{26, 27, 4, 5},
                                         {31, 32, 2, 5},
                                         {41, 42, 2, 5},
                                         {46, 47, 3, 4},
                                         {56, 57, 4, 9},
                                         {61, 62, 1, 5},
                                         {66, 67, 3, 8},
                                         {71, 72, 4, 5}}),
                                 Operation::unite);
  const Solid both = with_leaves_above(boolean(grooved, standing, Operation::unite), 30);
  Listener listener;
  BooleanOptions observed;
  observed.observer = &listener;
  const auto [above, below] = split(both, {1, 0, 0, 0});
  const auto [all_above, all_below] = split(both, {1, 0, 0, 0}, observed);
  EXPECT_TRUE(above == all_above);
  EXPECT_TRUE(below == all_below);
  EXPECT_TRUE(validate(above).empty());
  EXPECT_TRUE(validate(below).empty());
}

// Where nothing of the other solid is beside the line, each edge bounds the wedge that it has in
// its own solid, whatever it bounded before.
TEST(CrowdedBooks, HaveTheirOwnWedgesWhereTheyAreAlone) {
  Solid a = block({0, -17, 144}, {19, 7, 720});
  a = boolean(a, block({-21, -4, 352}, {0, 30, 672}), Operation::unite);
  a = boolean(a, block({-30, 0, -16}, {9, 12, 464}), Operation::unite);
  PolygonMesh prism;
  prism.positions = {{0, 0, -80},  {0, -47, 336},  {0, 54, 336},
                     {30, 0, -80}, {30, -47, 336}, {30, 54, 336}};
  prism.face_sizes = {3, 3, 4, 4, 4};
  prism.indices = {0, 1, 2, 3, 5, 4, 0, 3, 4, 1, 1, 4, 5, 2, 2, 5, 3, 0};
  Solid b = boolean(block({-6, -30, 304}, {0, 13, 368}), Solid::from_mesh(prism), Operation::unite);
  b = boolean(b, leaves({{37, 39, 13, 49}, {63, 65, 7, 47}, {1, 3, 38, 43}}), Operation::unite);
  b = Solid::from_mesh(b.to_mesh());  // with flat faces joined
  expect_the_same_for_an_observer(with_leaves_above(a, 0), with_leaves_above(b, 1));
}

TEST(CrowdedBooks, OfLeavesThatOverlapAllAroundObeyTheLawsOfSets) {
  for (const int lows : {40, 1})
    for (unsigned seed = 0; seed < cases(3u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_chain(random, 0, lows, false),
                  b = random_chain(random, 1, lows, false);
      test::expect_laws_of_sets(a, b);
    }
}

}  // namespace
}  // namespace sectile
