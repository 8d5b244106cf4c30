// All pairs of the 255 non-empty subsets of the eight unit cells of a 2×2×2 block, under ∪ ∩ \.
#include <gtest/gtest.h>

#include "pairs.h"

namespace sectile::test {
namespace {

using Faults = std::vector<std::string>;

// All (a, b) with a in steps of `stride`.
std::vector<Pair> pairs_of_subsets(Mask stride) {
  std::vector<Pair> pairs;
  for (Mask a = 1; a < 256; a += stride)
    for (Mask b = 1; b < 256; ++b) pairs.push_back({a, b});
  return pairs;
}

TEST(Cells, EverySubsetIsImportedExactly) {
  const Complex cubes = Complex::cubes(2);
  for (const Meshing how : all_meshings)
    for (Mask mask = 1; mask < 256; ++mask) {
      const Solid solid = Solid::from_mesh(Boundary(cubes, mask).mesh(how));
      EXPECT_EQ(fault(solid, cubes, mask, true), "") << mask << " meshing " << int(how);
    }
}

TEST(Cells, SomePairsOfAllMeshings) {
  const Complex cubes = Complex::cubes(2);
  for (const Meshing a : all_meshings) {
    // Each meshing with the one after it.
    const Meshing b = a == Meshing::merged ? Meshing::shared : Meshing(int(a) + 1);
    EXPECT_EQ(faults_of_pairs({cubes, a, b, true}, pairs_of_subsets(127)), Faults{})
        << "meshings " << int(a) << ' ' << int(b);
  }
}

TEST(CellsExhaustive, AllPairsWithSharedVertices) {
  const Complex cubes = Complex::cubes(2);
  EXPECT_EQ(faults_of_pairs({cubes, Meshing::shared, Meshing::shared, false}, pairs_of_subsets(1)),
            Faults{});
}

TEST(CellsExhaustive, AllPairsWithVerticesForEachWedge) {
  const Complex cubes = Complex::cubes(2);
  EXPECT_EQ(faults_of_pairs({cubes, Meshing::wedges, Meshing::wedges, false}, pairs_of_subsets(1)),
            Faults{});
}

TEST(CellsExhaustive, EveryFourthSetOfTrianglesWithOwnVertices) {
  const Complex cubes = Complex::cubes(2);
  EXPECT_EQ(faults_of_pairs({cubes, Meshing::own, Meshing::merged, false}, pairs_of_subsets(4)),
            Faults{});
}

}  // namespace
}  // namespace sectile::test
