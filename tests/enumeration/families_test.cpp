// Families of special positions: solids with themselves and their own parts,
// contacts in single points, shells in shells, surfaces that touch themselves,
// and coordinates of very unequal sizes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cases.h"
#include "fault.h"
#include "operations.h"
#include "sectile/sectile.h"
#include "volumes.h"

namespace sectile::test {
namespace {

Solid moved(const Solid& solid, const Vec3& by) {
  return transformed(solid, Transform::translation(by));
}
Solid cube(double low, double high) {
  return block({low, low, low}, {high, high, high});
}

Mask random_set(std::mt19937_64& random, const Complex& complex) {
  while (true)
    if (const Mask mask = random() & (random() | random()) & complex.all(); mask != 0) return mask;
}

TEST(Families, SolidsWithThemselvesAndTheirParts) {
  std::mt19937_64 random(1);
  const Complex complex = Complex::tetrahedra(2);
  for (int i = 0; i < 25; ++i) {
    const Mask mask = random_set(random, complex), part = mask & random();
    const Solid a = Solid::from_mesh(Boundary(complex, mask).mesh(Meshing::shared));
    EXPECT_EQ(unite(a, a), a);
    EXPECT_EQ(meet(a, a), a);
    EXPECT_TRUE(minus(a, a).is_empty());
    if (part == 0 || part == mask) continue;
    const Solid p = Solid::from_mesh(Boundary(complex, part).mesh(Meshing::own));
    const Solid q = minus(a, p);
    EXPECT_EQ(unite(p, q), a);
    EXPECT_TRUE(meet(p, q).is_empty());
    EXPECT_EQ(minus(a, q), p);
    EXPECT_FALSE(p == a);
  }
}

TEST(Families, SetsOfCellsAndTheirTranslatesByOneCell) {
  std::mt19937_64 random(2);
  const Complex cubes = Complex::cubes(2);
  for (int i = 0; i < 60; ++i) {
    const Mask mask = random_set(random, cubes);
    const Solid a = Solid::from_mesh(Boundary(cubes, mask).mesh(all_meshings[i % 5]));
    const int axis = i % 3;
    // Cells whose neighbour below along the axis is in the set as well.
    int common = 0;
    for (int c = 0; c < 8; ++c)
      if ((c >> axis & 1) != 0)
        common += Complex::has(mask, c) && Complex::has(mask, c - (1 << axis));
    const Vec3 by{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
    expect_volumes(a, moved(a, by), common);
  }
}

TEST(Families, BlocksThatMeetInAllTwentySixDirections) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Solid other = moved(cube(0, 2), {2.0 * x, 2.0 * y, 2.0 * z});
        expect_volumes(cube(0, 2), other, 0);
        // Faces of unequal sizes, then an overlap.
        expect_volumes(moved(cube(0, 1), {0.5, 0.5, 0.5}), other, 0);
        expect_volumes(cube(0, 2), moved(cube(0, 2), {1.0 * x, 1.0 * y, 1.0 * z}),
                       (x == 0 ? 2 : 1) * (y == 0 ? 2 : 1) * (z == 0 ? 2 : 1));
      }
}

TEST(Families, ShellsWithinShells) {
  Solid nest, complement = cube(-20, 20);
  double volume = 0;
  for (int i = 10; i > 0; i -= 2) {
    const Solid shell = minus(cube(-i, i), cube(-i + 1, i - 1));
    nest = unite(nest, shell);
    complement = minus(complement, shell);
    volume += 8.0 * (i * i * i - (i - 1) * (i - 1) * (i - 1));
  }
  EXPECT_EQ(nest.volume(), volume);
  EXPECT_EQ(nest.counts().shells, 10u);
  EXPECT_TRUE(validate(nest).empty());
  EXPECT_EQ(unite(nest, complement), cube(-20, 20));
  EXPECT_TRUE(meet(nest, complement).is_empty());
  // A plane through all of them, and a solid within one of the gaps.
  const Solid half = block({-30, -30, -30}, {30, 30, 0});
  expect_volumes(nest, half, volume / 2);
  expect_volumes(nest, block({-8.75, -8.75, 8.25}, {8.75, 8.75, 8.75}), 0);
}

TEST(Families, ACavityWhoseEdgeTouchesTheOuterFaceFromWithin) {
  Profile diamond;
  diamond.outer = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  const Solid outer = block({-4, -4, -4}, {4, 1, 4}), bar = extrude(diamond, 2);
  const Solid hollow = minus(outer, bar);
  EXPECT_TRUE(validate(hollow).empty());
  EXPECT_EQ(hollow.volume(), outer.volume() - 4);
  EXPECT_EQ(unite(hollow, bar), outer);
  EXPECT_TRUE(meet(hollow, bar).is_empty());
  // Blocks on the touching edge, across it, and one that takes the face away.
  expect_volumes(hollow, block({-1, 1, 0}, {1, 2, 2}), 0);
  expect_volumes(hollow, block({-1, 0, 0}, {1, 2, 1}), 1);
  expect_volumes(hollow, block({-4, 0, -4}, {4, 2, 4}), 64 - 2);
}

TEST(Families, FacesThatTouchThemselvesAndSlits) {
  // Squares cut out of a plate so that they touch in corners and in the plate's
  // rim.
  Solid plate = block({0, 0, 0}, {8, 8, 1});
  double volume = 64;
  for (int i = 0; i < 4; ++i) {
    plate = minus(plate, block({2.0 * i, 2.0 * i, -1}, {2.0 * i + 2, 2.0 * i + 2, 2}));
    volume -= 4;
    EXPECT_TRUE(validate(plate).empty());
    EXPECT_EQ(plate.volume(), volume);
  }
  expect_volumes(plate, block({1, 1, 0.25}, {7, 7, 0.75}), (36 - 4 * 2 - 2) * 0.5);
  // Slits of one unit in the last place, filled again.
  const double thin = 0x1p-50;
  const Solid slit = block({2, 0.5, -1}, {2 + thin, 7, 2}), whole = block({0, 0, 0}, {8, 8, 1});
  const Solid cut = minus(whole, slit);
  EXPECT_TRUE(validate(cut).empty());
  EXPECT_EQ(cut.counts().genus, 1);
  EXPECT_EQ(unite(cut, meet(slit, whole)), whole);
}

TEST(Families, ToriThroughEachOther) {
  const Solid a = torus(4, 1, 16, 8);
  const Solid b = moved(transformed(a, Transform::rotation_degrees({1, 0, 0}, 90)), {4, 0, 0});
  const Solid both = unite(a, b);
  EXPECT_TRUE(meet(a, b).is_empty());
  EXPECT_TRUE(validate(both).empty());
  EXPECT_EQ(both.counts().shells, 2u);
  EXPECT_EQ(both.counts().genus, 2);
  EXPECT_EQ(minus(both, b), a);
  const Solid crossing = transformed(a, Transform::rotation_degrees({1, 0, 0}, 90));
  const Solid common = meet(a, crossing), any = unite(a, crossing);
  EXPECT_TRUE(validate(common).empty());
  EXPECT_TRUE(validate(any).empty());
  EXPECT_EQ(common.counts().shells, 2u);
  EXPECT_EQ(minus(any, minus(any, common)), common);
}

TEST(Families, CoordinatesOfVeryUnequalSizes) {
  std::mt19937_64 random(3);
  const Complex complex = Complex::tetrahedra(2);
  struct Scale {
    int x, y, z;
  };
  for (const Scale& e : {Scale{-300, 300, 0}, Scale{300, 300, 300}, Scale{-300, -300, -300},
                         Scale{-1074, 500, 500}, Scale{0, 1000, -1000}}) {
    const Transform scale =
        Transform::scaling({std::ldexp(1, e.x), std::ldexp(1, e.y), std::ldexp(1, e.z)});
    for (int i = 0; i < 12; ++i) {
      const Mask p = random_set(random, complex), q = random_set(random, complex);
      const PolygonMesh mesh_p = Boundary(complex, p).mesh(Meshing::shared),
                        mesh_q = Boundary(complex, q).mesh(Meshing::merged);
      const Solid a = Solid::from_mesh(mesh_p), b = Solid::from_mesh(mesh_q),
                  c = Solid::from_mesh(transformed(mesh_p, scale)),
                  d = Solid::from_mesh(transformed(mesh_q, scale));
      for (const Operation operation : all_operations) {
        const Solid plain = boolean(a, b, operation), scaled = boolean(c, d, operation);
        const SolidCounts m = plain.counts(), n = scaled.counts();
        EXPECT_EQ(m.vertices, n.vertices);
        EXPECT_EQ(m.edges, n.edges);
        EXPECT_EQ(m.faces, n.faces);
        EXPECT_EQ(m.shells, n.shells);
        EXPECT_TRUE(validate(scaled).empty());
        EXPECT_EQ(scaled, plain.is_empty() ? plain : transformed(plain, scale));
      }
    }
  }
}

TEST(Families, ChainsOfSetsOfTetrahedraStayExact) {
  const Complex complex = Complex::tetrahedra(2);
  for (unsigned seed = 1; seed <= cases(6u); ++seed) {
    std::mt19937_64 random(seed);
    Solid solid;
    Mask mask = 0;
    for (int step = 0; step < 40; ++step) {
      const Mask tool = random_set(random, complex);
      // Seldom an intersection, so that something is left.
      const Operation operation = step % 8 == 7   ? Operation::intersect
                                  : step % 2 == 0 ? Operation::unite
                                                  : Operation::subtract;
      solid = boolean(solid, Solid::from_mesh(Boundary(complex, tool).mesh(Meshing::shared)),
                      operation);
      mask = combined(mask, tool, operation);
      ASSERT_EQ(fault(solid, complex, mask, step % 8 == 0), "")
          << "seed " << seed << " step " << step;
    }
  }
}

}  // namespace
}  // namespace sectile::test
