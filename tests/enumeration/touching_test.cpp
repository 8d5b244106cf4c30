// Soups of tetrahedra that touch each other in corners, along edges, where edges cross, and with
// corners and edges on faces, without the places of touching being vertices of both.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectile/sectile.h"

namespace sectile {
namespace {

using Random = std::mt19937;

PolygonMesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto from_a = [&](const Vec3& p) { return Vec3{p.x - a.x, p.y - a.y, p.z - a.z}; };
  const Vec3 u = from_a(b), v = from_a(c), w = from_a(d);
  const double volume =
      u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
  if (volume == 0) return {};
  return {volume > 0 ? std::vector{a, b, c, d} : std::vector{a, c, b, d},
          {3, 3, 3, 3},
          {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
}

PolygonMesh random_tetrahedron(Random& random, unsigned size) {
  const auto coordinate = [&] { return static_cast<double>(random() % (size + 1)); };
  const auto corner = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
  for (;;) {
    const Vec3 a = corner(), b = corner(), c = corner(), d = corner();
    if (PolygonMesh mesh = tetrahedron(a, b, c, d); !mesh.positions.empty()) return mesh;
  }
}

struct Touching {
  PolygonMesh soup;
  Solid united;

  /// Unless it overlaps the others or shares some of their surface.
  void add(const PolygonMesh& part) {
    const Solid solid = Solid::from_mesh(part);
    const Solid sum = boolean(united, solid, Operation::unite);
    const double area = united.area() + solid.area();
    if (!boolean(united, solid, Operation::intersect).is_empty() ||
        std::abs(sum.area() - area) > 1e-9 * area)
      return;
    united = sum;
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), part.positions.begin(), part.positions.end());
    soup.face_sizes.insert(soup.face_sizes.end(), part.face_sizes.begin(), part.face_sizes.end());
    for (const std::uint32_t i : part.indices) soup.indices.push_back(first + i);
  }
};

Touching random_soup(Random& random, unsigned size, int tries) {
  Touching result;
  for (int i = 0; i < tries; ++i) result.add(random_tetrahedron(random, size));
  return result;
}

void expect_laws(const Solid& a, const Solid& b) {
  const Solid any = boolean(a, b, Operation::unite), both = boolean(a, b, Operation::intersect),
              a_rest = boolean(a, b, Operation::subtract),
              b_rest = boolean(b, a, Operation::subtract);
  for (const Solid* s : {&any, &both, &a_rest, &b_rest}) EXPECT_TRUE(validate(*s).empty());
  EXPECT_NEAR(any.volume() + both.volume(), a.volume() + b.volume(), 1e-9);
  EXPECT_NEAR(a_rest.volume() + both.volume(), a.volume(), 1e-9);
  EXPECT_NEAR(b_rest.volume() + both.volume(), b.volume(), 1e-9);
  const Solid apart = boolean(a_rest, b_rest, Operation::unite);
  EXPECT_EQ(boolean(apart, both, Operation::unite), any);
  EXPECT_EQ(boolean(a, a_rest, Operation::subtract), both);
  EXPECT_EQ(boolean(any, b, Operation::subtract), a_rest);
}

void expect_laws_of_soups(unsigned from, unsigned to, unsigned size, int tries) {
  for (unsigned seed = from; seed < to && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", size " + std::to_string(size));
    Random random(seed);
    const Touching a = random_soup(random, size, tries), b = random_soup(random, size, tries);
    const Solid soup_a = Solid::from_mesh(a.soup), soup_b = Solid::from_mesh(b.soup);
    EXPECT_EQ(soup_a, a.united);
    EXPECT_EQ(boolean(soup_a, soup_b, Operation::unite),
              boolean(a.united, b.united, Operation::unite));
    expect_laws(soup_a, soup_b);
    const auto [above, below] = split(soup_a, HalfSpace{1, 1, 0, -static_cast<double>(size)});
    EXPECT_NEAR(above.volume() + below.volume(), soup_a.volume(), 1e-9);
    EXPECT_TRUE(validate(above).empty());
    EXPECT_TRUE(validate(below).empty());
  }
}

Solid soup_of(std::initializer_list<PolygonMesh> parts) {
  Touching soup;
  for (const PolygonMesh& part : parts) soup.add(part);
  return Solid::from_mesh(soup.soup);
}

TEST(Touching, AFaceEndsWhereALineRunsBesideTheOther) {
  const Solid a = soup_of({tetrahedron({0, 2, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 2}),
                           tetrahedron({2, 1, 2}, {2, 2, 1}, {2, 0, 2}, {1, 0, 0})});
  expect_laws(a, soup_of({tetrahedron({0, 1, 1}, {2, 2, 1}, {2, 0, 2}, {2, 2, 0})}));
}

TEST(Touching, TwoEdgesOfAFaceRunAlongOneLine) {
  const Solid a = soup_of({tetrahedron({2, 1, 1}, {2, 0, 1}, {1, 1, 2}, {0, 1, 1}),
                           tetrahedron({1, 1, 0}, {2, 2, 1}, {0, 2, 0}, {1, 2, 2})});
  expect_laws(a, soup_of({tetrahedron({2, 0, 2}, {1, 2, 1}, {1, 2, 0}, {1, 1, 1})}));
}

TEST(Touching, SomeRandomPairsOfSoups) {
  expect_laws_of_soups(0, 60, 2, 12);
  expect_laws_of_soups(0, 15, 3, 25);
}

TEST(TouchingExhaustive, AThousandRandomPairsOfSoups) {
  expect_laws_of_soups(100, 900, 2, 14);
  expect_laws_of_soups(100, 300, 3, 30);
}

}  // namespace
}  // namespace sectile
