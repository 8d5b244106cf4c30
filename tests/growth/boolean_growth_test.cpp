// Booleans in which very many things meet in one place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "append_mesh.h"
#include "boolean/boolean.h"
#include "growth/steps.h"
#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/repair.h"
#include "sectile/rounding.h"
#include "sectile/solid.h"
#include "sectile/transform.h"
#include "unit/walls_through_a_point.h"

namespace sectile {
namespace {

// Each side of one cone crosses two of the other, so that all of them are cut at the apex.
TEST(Growth, ConesThatShareAnApexHalfAStepTurned) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const auto sides = static_cast<std::uint32_t>(n);
                  const Solid a = cone(1, 0, 1, sides),
                              b = transformed(a, Transform::rotation_degrees(
                                                     {0, 0, 1}, 180.0 / static_cast<double>(n)));
                  boolean_by_cutting(a, a, Operation::unite, {});  // trees
                  return [a, b] { boolean(a, b, Operation::subtract); };
                },
                500),
            n_log_n);
}

void add(const std::initializer_list<std::uint32_t>& face, PolygonMesh& mesh) {
  mesh.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
  mesh.indices.insert(mesh.indices.end(), face);
}

// n tetrahedra that touch each other in one corner, away from which they point to all sides.
Solid bouquet(std::size_t n) {
  PolygonMesh mesh;
  const double count = static_cast<double>(n), width = 0.7 / std::sqrt(count);
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / count, r = std::sqrt(1 - z * z),
                 a = 2.4 * static_cast<double>(i);
    const Vec3 u{-std::sin(a), std::cos(a), 0}, v{-z * std::cos(a), -z * std::sin(a), r};
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({0, 0, 0});
    for (int k = 0; k < 3; ++k) {
      const double t = 2 * std::numbers::pi * k / 3, c = width * std::cos(t),
                   s = width * std::sin(t);
      mesh.positions.push_back({r * std::cos(a) + c * u.x + s * v.x,
                                r * std::sin(a) + c * u.y + s * v.y, z + c * u.z + s * v.z});
    }
    add({o, o + 2, o + 1}, mesh);
    add({o, o + 3, o + 2}, mesh);
    add({o, o + 1, o + 3}, mesh);
    add({o + 1, o + 2, o + 3}, mesh);
  }
  return Solid::from_mesh(mesh);
}

TEST(Growth, BouquetsThatShareTheirCorner) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid a = bouquet(n),
                              b = transformed(a, Transform::rotation_degrees({0, 0, 1}, 0.5));
                  return [a, b] { boolean(a, b, Operation::unite); };
                },
                100),
            n_log_n);
}

// n of them around a point on a ground, all turned by so much of a step.
Solid spikes_on_the_ground(std::size_t n, double turn) {
  PolygonMesh mesh;
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = step * (static_cast<double>(i) + turn), b = a + 0.4 * step, c = a + 0.2 * step;
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0},
                                                 {std::cos(a), std::sin(a), 0},
                                                 {std::cos(b), std::sin(b), 0},
                                                 {std::cos(c), std::sin(c), 0.01}});
    add({o, o + 2, o + 1}, mesh);
    add({o, o + 1, o + 3}, mesh);
    add({o + 1, o + 2, o + 3}, mesh);
    add({o + 2, o, o + 3}, mesh);
  }
  return Solid::from_mesh(mesh);
}

// A ray along the ground comes near to very many of them.
TEST(Growth, SpikesOnTheGroundBetweenEachOther) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth(
                  [&](std::size_t n) {
                    const Solid a = spikes_on_the_ground(n, 0), b = spikes_on_the_ground(n, 0.5);
                    return [=] { boolean(a, b, operation); };
                  },
                  50),
              n_log_n);
}

// n of them around an axis, flat and aslant: the directions of each are between those of very many
// others as far as boxes tell.
Solid flat_spikes(std::size_t n, double turn) {
  PolygonMesh mesh;
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = step * (static_cast<double>(i) + turn), x = std::cos(a), y = std::sin(a);
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({0, 0, 0});
    for (const auto& [along, beside] : {std::pair(-0.8, 0.0), {0.8, 0.0}, {0.0, 0.2 * step}})
      mesh.positions.push_back({x - y * (along + beside), y + x * (along + beside), along});
    add({o, o + 1, o + 2}, mesh);
    add({o, o + 2, o + 3}, mesh);
    add({o, o + 3, o + 1}, mesh);
    add({o + 3, o + 2, o + 1}, mesh);
  }
  return Solid::from_mesh(mesh);
}

// Those of one solid are between those of the other one, or reach into them.
TEST(Growth, BooleansOfWallsThroughOnePoint) {
  for (const double turn : {0.5, 0.125})
    EXPECT_LT(growth(
                  [&](std::size_t n) {
                    test::WallsThroughAPoint walls;
                    walls.count = static_cast<int>(n);
                    const Solid a = Solid::from_mesh(walls.mesh());
                    walls.turn = turn;
                    const Solid b = Solid::from_mesh(walls.mesh());
                    boolean_by_cutting(a, a, Operation::unite, {});  // trees
                    return [=] { boolean(a, b, Operation::unite); };
                  },
                  200),
              n_log_n);
}

// Far below n²: their ends, long and thin, cross one part of space in all directions.
TEST(Growth, BooleansOfFlatSpikesThatBeginInOnePoint) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth(
                  [&](std::size_t n) {
                    const Solid a = flat_spikes(n, 0), b = flat_spikes(n, 0.5);
                    boolean_by_cutting(a, a, Operation::unite, {});  // trees
                    return [=] { boolean(a, b, operation); };
                  },
                  100),
              1.55);
}

TEST(Growth, ImportOfABouquet) {
  EXPECT_LT(growth([](std::size_t n) { return [n] { bouquet(n); }; }, 250), n_log_n);
}

// n wedges on one line, each over so much of its n-th part of a turn: those that begin later than
// others do so by `lows`, and so for their ends.
PolygonMesh book(std::size_t n, double lows = 0, double highs = 0, double width = 0.5) {
  PolygonMesh mesh;
  const auto nth = [&](std::size_t i, std::size_t factor) {
    return static_cast<double>(factor * i % n);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double step = 2 * std::numbers::pi / static_cast<double>(n),
                 a = step * static_cast<double>(i), b = a + step * width;
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double z : {lows * nth(i, 7919), 1 + highs * nth(i, 10007)}) {
      mesh.positions.push_back({0, 0, z});
      mesh.positions.push_back({std::cos(a), std::sin(a), z});
      mesh.positions.push_back({std::cos(b), std::sin(b), z});
    }
    add({o, o + 2, o + 1}, mesh);
    add({o + 3, o + 4, o + 5}, mesh);
    add({o, o + 1, o + 4, o + 3}, mesh);
    add({o + 1, o + 2, o + 5, o + 4}, mesh);
    add({o + 2, o, o + 3, o + 5}, mesh);
  }
  return mesh;
}

TEST(Growth, ImportOfABook) {
  EXPECT_LT(growth([](std::size_t n) { return [mesh = book(n)] { Solid::from_mesh(mesh); }; }, 100),
            n_log_n);
}

TEST(Growth, ImportOfABookOfAllLengths) {
  for (const double lows : {0.0, 1e-4})
    EXPECT_LT(
        growth(
            [&](std::size_t n) { return [mesh = book(n, lows, 1e-4)] { Solid::from_mesh(mesh); }; },
            100),
        n_log_n)
        << lows;
}

double growth_of_separation(const std::function<Solid(std::size_t)>& make, std::size_t n,
                            Rounding rounding = {}) {
  rounding.separate_touching = true;
  return growth(
      [&](std::size_t m) { return [rounding, solid = make(m)] { rounded_mesh(solid, rounding); }; },
      n);
}

// All walls touch at both ends of their edge.
TEST(Growth, SeparationOfABook) {
  EXPECT_LT(growth_of_separation([](std::size_t n) { return Solid::from_mesh(book(n)); }, 200),
            n_log_n);
}

// The more walls there are, the farther from their edge is the next number within each.
TEST(Growth, SeparationOfABookOnAGrid) {
  Rounding grid;
  grid.numbers = Rounding::Numbers::grid;
  grid.spacing = 1e-6;
  EXPECT_LT(
      growth_of_separation(
          [](std::size_t n) {
            return transformed(Solid::from_mesh(book(n)), Transform::translation({0.3, 0.2, 0.1}));
          },
          400, grid),
      n_log_n);
}

// Where there are few numbers in thin walls.
Transform aslant() {
  return Transform::translation({0.3, 0.2, 0.1}) * Transform::rotation_degrees({1, 0.3, 0.7}, 20);
}

// Most of it is the test whether rounded walls cross.
TEST(Growth, SeparationOfASlantedBook) {
  EXPECT_LT(
      growth_of_separation(
          [](std::size_t n) { return transformed(Solid::from_mesh(book(n)), aslant()); }, 400),
      1.5);
}

// Both ends of the edge are in one fan each, as is all that has them in common on the floors.
Solid book_between_floors(std::size_t n) {
  const Solid floors =
      boolean(block({-2, -2, -1}, {2, 2, 0}), block({-2, -2, 1}, {2, 2, 2}), Operation::unite);
  return boolean(floors, Solid::from_mesh(book(n)), Operation::unite);
}

TEST(Growth, SeparationOfABookBetweenFloors) {
  EXPECT_LT(growth_of_separation(book_between_floors, 200), n_log_n);
}

TEST(Growth, SeparationOfASlantedBookBetweenFloors) {
  EXPECT_LT(growth_of_separation(
                [](std::size_t n) { return transformed(book_between_floors(n), aslant()); }, 200),
            n_log_n);
}

// Each wall goes off the line as a whole, and is not cut at the ends of all others; these are only
// looked for on all edges.
TEST(Growth, SeparationOfASlantedBookWhoseWallsAllEndElsewhere) {
  EXPECT_LT(growth_of_separation(
                [](std::size_t n) {
                  return transformed(Solid::from_mesh(book(n, 1e-4, 1e-4)), aslant());
                },
                100),
            2.1);
}

TEST(Growth, SeparationOfABouquet) {
  EXPECT_LT(growth_of_separation(bouquet, 100), n_log_n);
}

TEST(Growth, BooksAlongTheirCommonEdge) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid a = Solid::from_mesh(book(n)),
                              b = transformed(a, Transform::translation({0, 0, 0.5}));
                  return [a, b] { boolean(a, b, Operation::unite); };
                },
                60),
            n_log_n);
}

TEST(Growth, BooksWhosePagesCrossAlongTheirCommonEdge) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid a = Solid::from_mesh(book(n)),
                              b = transformed(a, Transform::rotation_degrees(
                                                     {0, 0, 1}, 90.0 / static_cast<double>(n)));
                  return [a, b] { boolean(a, b, Operation::subtract); };
                },
                60),
            n_log_n);
}

TEST(Growth, CellsOfBooksAlongTheirCommonEdge) {
  EXPECT_LT(
      growth(
          [](std::size_t n) {
            const Solid a = Solid::from_mesh(book(n));
            const std::vector<Solid> both{a, transformed(a, Transform::translation({0, 0, 0.5}))};
            return [both] { cells(both); };
          },
          40),
      n_log_n);
}

// Each end of a wall is within the edges of nearly all others: as many places in which they meet.
TEST(Growth, CellsOfBooksWhoseWallsAllEndElsewhere) {
  const auto cells_of_two = [](std::size_t n) {
    const Solid a = Solid::from_mesh(book(n, 1e-4, 1e-4));
    const std::vector<Solid> both{a, transformed(a, Transform::translation({0, 0, 0.5}))};
    return [both] { cells(both); };
  };
  EXPECT_LT(growth(cells_of_two, 25), 2.25);
}

PolygonMesh in_one_mesh(PolygonMesh a, const PolygonMesh& b) {
  test::append(b, a);
  return a;
}

// A solid needs corners only where its own surface bends.
TEST(Growth, RepairOfABookOnAFloor) {
  const auto on_floor = [](std::size_t n) {
    RepairOptions options;
    options.rule = Rule::odd;
    const PolygonMesh mesh =
        in_one_mesh(block({-2, -2, -1}, {2, 0, 3}).to_mesh(), book(n, 1e-4, 1e-4));
    return [=] { repair(mesh, options); };
  };
  EXPECT_LT(growth(on_floor, 200), n_log_n);
}

// Each wall has its edge in common with one of the other book, and overlaps two of it.
TEST(Growth, RepairOfBooksThatCrossAlongTheirCommonEdge) {
  const auto of_two = [](std::size_t n) {
    PolygonMesh other = book(n, 1e-4, 1e-4, 0.7);
    const double half = std::numbers::pi / static_cast<double>(n), c = std::cos(half),
                 s = std::sin(half);
    for (Vec3& p : other.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    const PolygonMesh mesh = in_one_mesh(book(n, 1e-4, 1e-4, 0.7), other);
    return [=] { repair(mesh); };
  };
  EXPECT_LT(growth(of_two, 200), n_log_n);
}

// Each turned by so many degrees over n against itself, so that walls of both are beside each other
// two by two: no other end of a wall divides them.
double growth_of_books_that_end_elsewhere(Operation operation, double turn, double lows,
                                          double width = 0.5) {
  const auto of_two = [=](std::size_t n) {
    const Solid a = Solid::from_mesh(book(n, lows, 1e-4, width)),
                b = transformed(
                    a, Transform::rotation_degrees({0, 0, 1}, turn / static_cast<double>(n)));
    return [=] { boolean(a, b, operation); };
  };
  return growth(of_two, 100);
}

TEST(Growth, BooleansOfBooksWhoseWallsAllEndElsewhere) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    for (const double turn : {45.0, 90.0})
      EXPECT_LT(growth_of_books_that_end_elsewhere(operation, turn, 1e-4), n_log_n);
}

// Each wall overlaps two of the other book, all around the line.
TEST(Growth, BooleansOfBooksWhoseWallsOverlapAllAround) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth_of_books_that_end_elsewhere(operation, 180, 1e-4, 0.7), n_log_n);
}

TEST(Growth, BooleansOfBooksWhoseWallsBeginInOnePlace) {
  for (const Operation operation : {Operation::unite, Operation::intersect})
    EXPECT_LT(growth_of_books_that_end_elsewhere(operation, 90, 0), n_log_n);
}

// All edges of the line are paired anew for the complement. The ends are in no order: on a stair
// around the line, one wall would be beside the ends of many.
TEST(Growth, SubtractionOfABookWhoseWallsBeginInOnePlace) {
  const auto of_two = [](std::size_t n) {
    PolygonMesh mesh = book(n);
    std::vector<double> ends;
    for (std::size_t i = 0; i < n; ++i) ends.push_back(1 + 1e-4 * static_cast<double>(i));
    std::ranges::shuffle(ends, std::mt19937(1));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      if (mesh.positions[i].z > 0) mesh.positions[i].z = ends[i / 6];
    const Solid a = Solid::from_mesh(mesh),
                b = transformed(
                    a, Transform::rotation_degrees({0, 0, 1}, 90.0 / static_cast<double>(n)));
    return [=] { boolean(a, b, Operation::subtract); };
  };
  EXPECT_LT(growth(of_two, 200), n_log_n);
}

// A book of which one half is above the floor of a block, in which its line runs, and the other one
// in the block.
double growth_of_books_with_floor(const std::function<Solid(const Solid&, const Solid&)>& make,
                                  Operation operation, std::size_t n) {
  return growth(
      [&](std::size_t m) {
        const Solid floor = block({-2, -2, -1}, {2, 0, 3}),
                    b = Solid::from_mesh(book(m, 1e-4, 1e-4)),
                    other = transformed(
                        b, Transform::rotation_degrees({0, 0, 1}, 90.0 / static_cast<double>(m)));
        const Solid a = make(floor, other);
        return [=] { boolean(a, b, operation); };
      },
      n);
}

TEST(Growth, BooleansOfABookOnAFloor) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth_of_books_with_floor([](const Solid& floor, const Solid&) { return floor; },
                                         operation, 200),
              n_log_n);
}

TEST(Growth, BooleansOfBooksOfWhichOneStandsOnAFloor) {
  const auto with_floor = [](const Solid& floor, const Solid& book) {
    return boolean(floor, book, Operation::unite);
  };
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth_of_books_with_floor(with_floor, operation, 100), n_log_n);
}

// The floor has two edges in the line, and touches itself there.
TEST(Growth, BooleansOfABookAndAFloorWithGrooves) {
  const auto with_grooves = [](const Solid& floor, const Solid& book) {
    return boolean(floor, book, Operation::subtract);
  };
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    EXPECT_LT(growth_of_books_with_floor(with_grooves, operation, 100), n_log_n);
}

// Walls on one side of the plane of two lines that cross, along one of them, and on the other side.
Solid half_book(std::size_t n, double y, double low) {
  const Solid half = boolean(Solid::from_mesh(book(2 * n, 1e-4, 1e-4)),
                             block({-2, y, -1}, {2, y + 2, 3}), Operation::intersect);
  return transformed(half, Transform::translation({0, 0, low}));
}
Solid upper_book(std::size_t n) {
  return half_book(n, 0, -0.5);
}
Solid lower_book(std::size_t n) {
  return transformed(half_book(n, -2, -0.4), Transform::rotation_degrees({0, 1, 0}, 90));
}

// One stands on the floor, and the line of the other one, in the body below it, crosses its line.
TEST(Growth, BooleansOfBooksWhoseLinesCrossInAFloor) {
  const auto across = [](std::size_t n) {
    const Solid floor = block({-2, -2, -2}, {2, 0, 2}),
                books = boolean(upper_book(n), lower_book(n), Operation::unite);
    return [=] { boolean(floor, books, Operation::subtract); };
  };
  EXPECT_LT(growth(across, 100), n_log_n);
}

// All edges along one line run through one point with all those along the other one.
TEST(Growth, BooleansOfBooksOnBothSidesOfThePlaneOfTheirLines) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const auto across = [&](std::size_t n) {
      const Solid a = upper_book(n), b = lower_book(n);
      return [=] { boolean(a, b, operation); };
    };
    EXPECT_LT(growth(across, 100), n_log_n);
  }
}

// The plane has the line in it, and nothing else but what crosses it there.
TEST(Growth, SplitOfABookThroughItsLine) {
  const auto through_line = [](std::size_t n) {
    const Solid both = boolean(block({-2, -2, -1}, {2, 0, 3}),
                               Solid::from_mesh(book(n, 1e-4, 1e-4)), Operation::unite);
    return [=] { split(both, {1, 0.25, 0, 0}); };
  };
  EXPECT_LT(growth(through_line, 200), n_log_n);
}

TEST(Growth, ClassificationOfABookOnAFloor) {
  const auto on_floor = [](std::size_t n) {
    const Solid floor = block({-2, -2, -1}, {2, 0, 3}), b = Solid::from_mesh(book(n, 1e-4, 1e-4));
    return [=] { classify(floor, b); };
  };
  EXPECT_LT(growth(on_floor, 200), n_log_n);
}

}  // namespace
}  // namespace sectile
