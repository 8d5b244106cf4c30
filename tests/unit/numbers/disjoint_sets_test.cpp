#include "numbers/disjoint_sets.h"

#include <gtest/gtest.h>

namespace sectile {
namespace {

TEST(DisjointSets, AreKnownByTheirLeastMember) {
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(4, 1);
  sets.unite(3, 4);
  for (const std::uint32_t i : {1u, 3u, 4u, 5u}) EXPECT_EQ(sets.first(i), 1u);
  EXPECT_EQ(sets.first(0), 0u);
  EXPECT_EQ(sets.first(2), 2u);
}

TEST(DisjointSets, AreNumberedInTheOrderOfTheirLeastMembers) {
  DisjointSets sets(6);
  sets.unite(5, 0);
  sets.unite(4, 2);
  const DisjointSets::Numbered numbered = std::move(sets).numbered();
  EXPECT_EQ(numbered.count, 4u);
  EXPECT_EQ(numbered.of, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 0}));
}

TEST(DisjointSets, OfNothingAreNone) {
  EXPECT_EQ(DisjointSets(0).numbered().count, 0u);
}

}  // namespace
}  // namespace sectile
