// All pairs of the 255 non-empty subsets of the eight unit cells of a 2×2×2 block, under ∪ ∩ \.
#include <gtest/gtest.h>

#include <random>

#include "cases.h"
#include "pairs.h"
#include "sectile/primitives.h"

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

// What is around a set touches itself where the set does, but has one vertex where the set has two.
std::string fault_when_cut_out_twice(const Complex& cubes, Mask mask, Meshing how,
                                     const Solid& around) {
  const Solid set = Solid::from_mesh(Boundary(cubes, mask).mesh(how));
  const Solid mould = boolean(around, set, Operation::subtract);
  return fault(boolean(around, mould, Operation::subtract), cubes, mask, false);
}

TEST(Cells, WhatIsLeftOfABlockWithoutWhatIsLeftOfItWithoutASubsetIsTheSubset) {
  const Complex cubes = Complex::cubes(2);
  for (const Solid& around : {block({-1, -1, -1}, {3, 3, 3}), block({0, 0, 0}, {2, 2, 2})})
    for (const Meshing how : {Meshing::shared, Meshing::merged})
      for (Mask mask = 1; mask < 256; ++mask)
        EXPECT_EQ(fault_when_cut_out_twice(cubes, mask, how, around), "")
            << mask << " meshing " << int(how);
}

TEST(Cells, TheSameForSubsetsOf27Cells) {
  const Complex cubes = Complex::cubes(3);
  const Solid around[] = {block({-1, -1, -1}, {4, 4, 4}), block({0, 0, 0}, {3, 3, 3})};
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const Mask mask = random() & random() & cubes.all();
    for (const Meshing how : {Meshing::shared, Meshing::merged})
      EXPECT_EQ(fault_when_cut_out_twice(cubes, mask, how, around[i % 2]), "")
          << mask << " meshing " << int(how);
  }
}

struct Cells {
  Mask mask = 0;
  Solid solid;
};

// Results go on as operands. The first fault, with the step.
std::string fault_in_chain(const Complex& complex, unsigned seed, int steps) {
  std::mt19937_64 random(seed);
  const auto imported = [&](Mask mask, Meshing how) {
    return Cells{mask, Solid::from_mesh(Boundary(complex, mask).mesh(how))};
  };
  std::vector<Cells> pool = {imported(complex.all(), Meshing::merged)};
  while (pool.size() < 6)
    if (const Mask some = random() & random() & complex.all(); some != 0)
      pool.push_back(imported(some, pool.size() % 2 == 0 ? Meshing::shared : Meshing::wedges));
  for (int step = 0; step < steps; ++step) {
    const Cells &a = pool[random() % pool.size()], &b = pool[random() % pool.size()];
    const Operation operation = all_operations[random() % 3];
    const Cells made{combined(a.mask, b.mask, operation), boolean(a.solid, b.solid, operation)};
    if (const std::string what = fault(made.solid, complex, made.mask, false); !what.empty())
      return "seed " + std::to_string(seed) + ", step " + std::to_string(step) + ": " + what;
    if (made.mask != 0) pool[1 + random() % (pool.size() - 1)] = made;
  }
  return {};
}

TEST(Cells, ChainsOfAllOperationsHaveTheShellsAndHolesThatAreCounted) {
  for (const Complex& complex :
       {Complex::cubes(2), Complex::cubes(3), Complex::tetrahedra(2), Complex::fan()})
    for (unsigned seed = 1; seed <= cases(12u); ++seed)
      EXPECT_EQ(fault_in_chain(complex, seed, 40), "");
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
