// All pairs of the 255 non-empty subsets of the eight unit cells of a 2×2×2 block, under ∪ ∩ \.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <mutex>

#include "cells.h"
#include "inside.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

constexpr Operation operations[] = {Operation::unite, Operation::intersect, Operation::subtract};

unsigned combined(unsigned a, unsigned b, Operation operation) {
  switch (operation) {
    case Operation::unite:
      return a | b;
    case Operation::intersect:
      return a & b;
    case Operation::subtract:
      break;
  }
  return a & ~b;
}

// What is wrong with a result; empty if nothing.
std::string fault(const Solid& result, unsigned mask, bool geometry) {
  const CellSet wanted = CellSet::of_mask(mask);
  if (result.volume() != wanted.volume()) return "volume " + std::to_string(result.volume());
  if (result.area() != wanted.area()) return "area " + std::to_string(result.area());
  const auto violations = validate(result, geometry);
  if (!violations.empty()) return violations.front().what;
  const PolygonMesh mesh = result.to_mesh();
  for (int i = 0; i < 8; ++i) {
    // Beside the centre, so that the ray passes through no diagonal of a square.
    const Vec3 p{(i & 1) + 0.5, (i >> 1 & 1) + 0.5625, (i >> 2) + 0.375};
    if (is_inside(mesh, p) != wanted.has(i & 1, i >> 1 & 1, i >> 2))
      return "cell " + std::to_string(i);
  }
  return {};
}

std::vector<Solid> all_subsets(Meshing how) {
  std::vector<Solid> solids(256);
  for (unsigned mask = 1; mask < 256; ++mask)
    solids[mask] = Solid::from_mesh(CellSet::of_mask(mask).mesh(how));
  return solids;
}

// Runs all pairs (a, b) with a in steps of `stride`, and collects what is wrong.
std::vector<std::string> faults_of_pairs(Meshing how, unsigned stride, bool geometry) {
  const std::vector<Solid> solids = all_subsets(how);
  std::vector<std::string> faults;
  std::mutex mutex;
  tbb::parallel_for(1u, 256u, stride, [&](unsigned a) {
    for (unsigned b = 1; b < 256; ++b)
      for (const Operation operation : operations) {
        std::string what;
        try {
          what =
              fault(boolean(solids[a], solids[b], operation), combined(a, b, operation), geometry);
        } catch (const std::exception& error) {
          what = error.what();
        }
        if (what.empty()) continue;
        const std::lock_guard lock(mutex);
        faults.push_back(std::to_string(a) + " with " + std::to_string(b) + ", operation " +
                         std::to_string(static_cast<int>(operation)) + ": " + what);
      }
  });
  return faults;
}

TEST(Cells, EverySubsetIsImportedExactly) {
  for (const Meshing how : {Meshing::shared, Meshing::triangles, Meshing::own}) {
    const std::vector<Solid> solids = all_subsets(how);
    for (unsigned mask = 1; mask < 256; ++mask)
      EXPECT_EQ(fault(solids[mask], mask, true), "") << mask;
  }
}

TEST(Cells, SomePairsOfSharedSquaresIncludingCrossings) {
  EXPECT_EQ(faults_of_pairs(Meshing::shared, 85, true), std::vector<std::string>{});
}

TEST(CellsExhaustive, AllPairsOfSharedSquares) {
  EXPECT_EQ(faults_of_pairs(Meshing::shared, 1, false), std::vector<std::string>{});
}

TEST(CellsExhaustive, ManyPairsOfTrianglesWithOwnVertices) {
  EXPECT_EQ(faults_of_pairs(Meshing::own, 4, false), std::vector<std::string>{});
}

}  // namespace
}  // namespace sectile::test
