// Pairs of sets of the 48 Kuhn tetrahedra of a 2×2×2 block: boundaries with slanted faces in six
// directions, up to 24 tetrahedra around one vertex, and edges of several wedges of material.
#include <gtest/gtest.h>

#include <random>

#include "pairs.h"

namespace sectile::test {
namespace {

using Faults = std::vector<std::string>;

// Sets of all densities: few tetrahedra that touch here and there, about half, nearly all.
Mask random_set(std::mt19937_64& random, Mask all) {
  while (true) {
    Mask mask = random() & all;
    const auto thinned = random() % 7;
    if (thinned < 3) mask &= random();
    if (thinned == 0) mask &= random();
    if (thinned > 4) mask |= random() & all;
    if (mask != 0) return mask;
  }
}

std::vector<Pair> random_pairs(unsigned seed, std::size_t count, Mask all) {
  std::mt19937_64 random(seed);
  std::vector<Pair> pairs(count);
  for (Pair& pair : pairs) {
    pair.a = random_set(random, all);
    pair.b = random_set(random, all);
  }
  return pairs;
}

TEST(Kuhn, RandomSetsAreImportedExactly) {
  const Complex complex = Complex::tetrahedra(2);
  for (const Pair& pair : random_pairs(1, 100, complex.all()))
    for (const Meshing how : all_meshings) {
      const Solid solid = Solid::from_mesh(Boundary(complex, pair.a).mesh(how));
      EXPECT_EQ(fault(solid, complex, pair.a, true), "") << pair.a << " meshing " << int(how);
    }
}

TEST(Kuhn, SingleTetrahedraOfACubeInAllPairs) {
  const Complex complex = Complex::tetrahedra(2);
  std::vector<Pair> pairs;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < complex.cell_count(); ++b) pairs.push_back({Mask{1} << a, Mask{1} << b});
  EXPECT_EQ(faults_of_pairs({complex, Meshing::shared, Meshing::shared, true}, pairs), Faults{});
}

TEST(Kuhn, SomeRandomPairsOfAllMeshings) {
  const Complex complex = Complex::tetrahedra(2);
  unsigned seed = 2;
  for (const Meshing a : {Meshing::shared, Meshing::wedges, Meshing::own, Meshing::merged})
    for (const Meshing b : {Meshing::shared, Meshing::wedges, Meshing::own, Meshing::merged})
      EXPECT_EQ(faults_of_pairs({complex, a, b, true}, random_pairs(seed++, 40, complex.all())),
                Faults{})
          << "meshings " << int(a) << ' ' << int(b);
}

// Taken for crowded, its lines leave no corner of the shell to begin a ray in.
TEST(Kuhn, AShellAllOfWhoseCornersAreOnLinesOfTheOtherSet) {
  const Complex complex = Complex::tetrahedra(2);
  const Pair pairs[] = {{0x6400009809a2, 0x40091}, {0x668c659979aa, 0x1409048091}};
  EXPECT_EQ(faults_of_pairs({complex, Meshing::shared, Meshing::shared, false}, pairs), Faults{});
}

TEST(KuhnExhaustive, TwentyThousandRandomPairsWithSharedVertices) {
  const Complex complex = Complex::tetrahedra(2);
  EXPECT_EQ(faults_of_pairs({complex, Meshing::shared, Meshing::shared, false},
                            random_pairs(100, 20000, complex.all())),
            Faults{});
}

TEST(KuhnExhaustive, AThousandRandomPairsOfMergedFacesWithVerticesForEachWedge) {
  const Complex complex = Complex::tetrahedra(2);
  EXPECT_EQ(faults_of_pairs({complex, Meshing::merged, Meshing::wedges, true},
                            random_pairs(200, 1000, complex.all())),
            Faults{});
}

}  // namespace
}  // namespace sectile::test
