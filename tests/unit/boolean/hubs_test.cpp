// Points in which very many faces meet.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr std::uint32_t sides = 200;

Solid cone_upwards() {
  return transformed(cone(1, 0, 1, sides), Transform::translation({0, 0, -1}));
}
Solid turned_about_apex(double degrees) {
  return transformed(cone_upwards(), Transform::rotation_degrees({1, 0, 0}, degrees));
}

void expect_exact(const Solid& a, const Solid& b, double common) {
  const Solid both = boolean(a, b, Operation::unite), inner = boolean(a, b, Operation::intersect),
              rest = boolean(a, b, Operation::subtract);
  for (const Solid& s : {both, inner, rest}) EXPECT_TRUE(validate(s).empty());
  EXPECT_NEAR(inner.volume(), common, 1e-12);
  EXPECT_NEAR(both.volume() + inner.volume(), a.volume() + b.volume(), 1e-12);
  EXPECT_NEAR(rest.volume(), a.volume() - common, 1e-12);
}

TEST(Hubs, ConesThatTouchInTheirApexes) {
  expect_exact(cone_upwards(), turned_about_apex(180), 0);
}

TEST(Hubs, ConesTurnedAboutTheirCommonApex) {
  for (const double degrees : {91.0, 100.0, 135.0})
    expect_exact(cone_upwards(), turned_about_apex(degrees), 0);
}

TEST(Hubs, ConesThatOverlapFromTheirCommonApexOn) {
  const Solid a = cone_upwards();
  for (const double degrees : {1e-9, 0.5, 30.0, 89.0}) {
    const Solid b = turned_about_apex(degrees);
    expect_exact(a, b, boolean(a, b, Operation::intersect).volume());
    EXPECT_GT(boolean(a, b, Operation::intersect).volume(), 0);
  }
}

TEST(Hubs, AConeWithinAWiderOneWithTheSameApex) {
  const Solid narrow = transformed(cone(0.5, 0, 1, sides), Transform::translation({0, 0, -1}));
  expect_exact(cone_upwards(), narrow, narrow.volume());
}

TEST(Hubs, ResultsWithSeveralVerticesInOneHubAreOperandsAgain) {
  const Solid twice = boolean(cone_upwards(), turned_about_apex(180), Operation::unite);
  expect_exact(twice, twice, twice.volume());
  const Solid crossed = turned_about_apex(90);
  expect_exact(twice, crossed, boolean(twice, crossed, Operation::intersect).volume());
}

// A bouquet: tetrahedra between the origin and triangles on the surface of a cube around it. No two
// have a face in common, but many an edge.
using Triangle = std::array<Vec3, 3>;

std::vector<Triangle> surface_of_cube(int half, bool other_diagonal) {
  std::vector<Triangle> triangles;
  const auto place = [half](int axis, int side, int u, int v) {
    const int w = side * half;
    // Both sides counter-clockwise, seen from outside.
    const int a = side > 0 ? u : v, b = side > 0 ? v : u;
    const double at[3] = {double(w), double(a), double(b)};
    return Vec3{at[(3 - axis) % 3], at[(4 - axis) % 3], at[(5 - axis) % 3]};
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1})
      for (int u = -half; u < half; ++u)
        for (int v = -half; v < half; ++v) {
          const Vec3 p = place(axis, side, u, v), q = place(axis, side, u + 1, v),
                     r = place(axis, side, u + 1, v + 1), s = place(axis, side, u, v + 1);
          if (other_diagonal) {
            triangles.push_back({p, q, s});
            triangles.push_back({q, r, s});
          } else {
            triangles.push_back({p, q, r});
            triangles.push_back({p, r, s});
          }
        }
  return triangles;
}

std::vector<Triangle> some_without_common_edges(std::vector<Triangle> triangles, std::size_t count,
                                                std::mt19937& random) {
  std::shuffle(triangles.begin(), triangles.end(), random);
  const auto key = [](const Vec3& p) { return std::array{p.x, p.y, p.z}; };
  std::set<std::set<std::array<double, 3>>> edges;
  std::vector<Triangle> some;
  for (const Triangle& t : triangles) {
    std::array<std::set<std::array<double, 3>>, 3> own;
    for (std::size_t k = 0; k < 3; ++k) own[k] = {key(t[k]), key(t[(k + 1) % 3])};
    if (edges.contains(own[0]) || edges.contains(own[1]) || edges.contains(own[2])) continue;
    edges.insert(own.begin(), own.end());
    some.push_back(t);
    if (some.size() == count) break;
  }
  return some;
}

PolygonMesh bouquet(std::span<const Triangle> triangles) {
  PolygonMesh mesh;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({0, 0, 0});
    mesh.positions.insert(mesh.positions.end(), t.begin(), t.end());
    for (const std::uint32_t k : {1u, 2u, 3u, 0u, 2u, 1u, 0u, 3u, 2u, 0u, 1u, 3u})
      mesh.indices.push_back(first + k);
    mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
  }
  return mesh;
}

std::vector<Solid> single(std::span<const Triangle> triangles) {
  std::vector<Solid> solids;
  for (const Triangle& t : triangles) solids.push_back(Solid::from_mesh(bouquet({&t, 1})));
  return solids;
}

// What the two have in common and what is left, tetrahedron by tetrahedron.
TEST(Hubs, BouquetsAreWhatTheirTetrahedraAre) {
  for (unsigned seed = 0; seed < cases(6u); ++seed) {
    std::mt19937 random(seed);
    const auto of_a = some_without_common_edges(surface_of_cube(2, false), 30, random),
               of_b = some_without_common_edges(surface_of_cube(3, seed % 2 == 0), 40, random);
    const Solid a = Solid::from_mesh(bouquet(of_a)), b = Solid::from_mesh(bouquet(of_b));
    const std::vector<Solid> each_a = single(of_a), each_b = single(of_b);
    std::vector<Solid> common, rest;
    for (const Solid& s : each_a) {
      for (const Solid& t : each_b) common.push_back(boolean(s, t, Operation::intersect));
      rest.push_back(subtract(s, each_b));
    }
    EXPECT_TRUE(boolean(a, b, Operation::intersect) == unite(common)) << "seed " << seed;
    EXPECT_TRUE(boolean(a, b, Operation::subtract) == unite(rest)) << "seed " << seed;
    std::vector<Solid> all = each_a;
    all.insert(all.end(), each_b.begin(), each_b.end());
    EXPECT_TRUE(boolean(a, b, Operation::unite) == unite(all)) << "seed " << seed;
    const std::vector<Solid> both{a, b};
    for (const SolidCell& cell : cells(both))
      EXPECT_TRUE(cell.solid == (cell.operands.size() == 2 ? unite(common)
                                 : cell.operands[0] == 0   ? unite(rest)
                                                           : boolean(b, a, Operation::subtract)))
          << "seed " << seed;
  }
}

// Edges of another bouquet, or of several, pass through the one corner where all the others meet.
TEST(Hubs, BouquetsThatEdgesPassThrough) {
  for (const unsigned seed : {1u, 35u, 89u, 130u}) {
    std::mt19937 random(seed);
    std::vector<Solid> parts;
    for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}}) {
      const auto some = some_without_common_edges(surface_of_cube(2, false), 30, random);
      parts.push_back(transformed(Solid::from_mesh(bouquet(some)), Transform::translation(at)));
    }
    const Solid a = boolean(parts[0], parts[1], Operation::unite),
                b = unite(std::vector<Solid>{parts[0], parts[2], parts[3]});
    const Solid of_parts =
        unite(std::vector<Solid>{parts[0], boolean(parts[1], parts[2], Operation::intersect),
                                 boolean(parts[1], parts[3], Operation::intersect)});
    EXPECT_TRUE(boolean(a, b, Operation::intersect) == of_parts) << "seed " << seed;
    EXPECT_TRUE(boolean(a, b, Operation::unite) == unite(parts)) << "seed " << seed;
    EXPECT_TRUE(boolean(a, b, Operation::subtract) ==
                subtract(parts[1], std::vector<Solid>{parts[0], parts[2], parts[3]}))
        << "seed " << seed;
  }
}

// A wedge between two half-planes around the z axis, which are numbered; n half-planes are a turn.
PolygonMesh wedge(double first, double second, double n, double low, double high) {
  PolygonMesh mesh;
  for (const double z : {low, high}) {
    mesh.positions.push_back({0, 0, z});
    for (const double i : {first, second}) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
    }
  }
  mesh.face_sizes = {3, 3, 4, 4, 4};
  mesh.indices = {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  return mesh;
}

// A book: every other one of the wedges between n half-planes, beginning at one of them.
std::vector<Solid> pages(double first, double n, double low, double high) {
  std::vector<Solid> pages;
  for (double i = first; i < first + n; i += 2)
    pages.push_back(Solid::from_mesh(wedge(i, i + 1, n, low, high)));
  return pages;
}
Solid book(double first, double n, double low, double high) {
  return unite(pages(first, n, low, high));
}

TEST(Hubs, BooksAlongTheirCommonEdge) {
  constexpr double n = 160;
  const Solid a = book(0, n, 0, 2), b = book(0, n, 1, 3);
  EXPECT_TRUE(boolean(a, b, Operation::unite) == book(0, n, 0, 3));
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == book(0, n, 1, 2));
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == book(0, n, 0, 1));
}

TEST(Hubs, BooksWhosePagesLieBetweenEachOther) {
  constexpr double n = 160;
  const Solid a = book(0, n, 0, 2), between = book(1, n, 1, 3), half = book(0.5, n, 1, 3);
  EXPECT_TRUE(boolean(a, between, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(a, between, Operation::subtract) == a);
  std::vector<Solid> common;
  for (const Solid& p : pages(0, n, 0, 2)) common.push_back(boolean(p, half, Operation::intersect));
  EXPECT_TRUE(boolean(a, half, Operation::intersect) == unite(common));
}

}  // namespace
}  // namespace sectile
