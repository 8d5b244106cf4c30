// Sets of eight prisms around one edge: all numbers of wedges of material of both operands around a
// line, in all orders and with all ties (paper, 6.2, Table I).
#include <gtest/gtest.h>

#include "pairs.h"

namespace sectile::test {
namespace {

using Faults = std::vector<std::string>;

std::vector<Pair> pairs_of_sets(Mask first, Mask stride) {
  std::vector<Pair> pairs;
  for (Mask a = first; a < 256; a += stride)
    for (Mask b = 1; b < 256; ++b) pairs.push_back({a, b});
  return pairs;
}

TEST(Fan, EverySetIsImportedExactly) {
  const Complex fan = Complex::fan();
  for (const Meshing how : all_meshings)
    for (Mask mask = 1; mask < 256; ++mask) {
      const Solid solid = Solid::from_mesh(Boundary(fan, mask).mesh(how));
      EXPECT_EQ(fault(solid, fan, mask, true), "") << mask << " meshing " << int(how);
    }
}

TEST(Fan, SetsOfOneToFourWedgesWithAllSets) {
  const Complex fan = Complex::fan();
  std::vector<Pair> pairs;
  for (const Mask a : {0x01u, 0x1Fu, 0x33u, 0x45u, 0x55u, 0xF6u, 0xFFu})
    for (Mask b = 1; b < 256; ++b) pairs.push_back({a, b});
  EXPECT_EQ(faults_of_pairs({fan, Meshing::shared, Meshing::shared, true}, pairs), Faults{});
}

TEST(FanExhaustive, EverySeventhSetWithVerticesForEachWedge) {
  const Complex fan = Complex::fan();
  EXPECT_EQ(faults_of_pairs({fan, Meshing::merged, Meshing::own, false}, pairs_of_sets(1, 7)),
            Faults{});
}

}  // namespace
}  // namespace sectile::test
