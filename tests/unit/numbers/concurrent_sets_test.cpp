#include "numbers/concurrent_sets.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <utility>
#include <vector>

#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

TEST(ConcurrentSets, AreKnownByTheirLeastMember) {
  ConcurrentSets sets(6);
  sets.separate(3, 6);
  sets.separate(0, 3);
  EXPECT_TRUE(sets.unite(5, 3));
  EXPECT_TRUE(sets.unite(4, 1));
  EXPECT_TRUE(sets.unite(3, 4));
  EXPECT_FALSE(sets.unite(5, 1));
  for (const std::uint32_t i : {1u, 3u, 4u, 5u}) EXPECT_EQ(sets.first(i), 1u);
  EXPECT_TRUE(sets.is_first(1));
  EXPECT_FALSE(sets.is_first(5));
  EXPECT_EQ(sets.first(0), 0u);
  EXPECT_EQ(sets.first(2), 2u);
}

TEST(ConcurrentSets, AreTheSameWhenManyThreadsUniteThem) {
  constexpr std::uint32_t count = 20000;
  std::mt19937 random(5);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < 30000; ++i) pairs.emplace_back(random() % count, random() % count);
  DisjointSets expected(count);
  std::size_t united = 0;
  for (const auto& [i, j] : pairs) {
    united += expected.first(i) != expected.first(j);
    expected.unite(i, j);
  }
  for (int round = 0; round < 20; ++round) {
    ConcurrentSets sets(count);
    sets.separate(0, count);
    std::atomic<std::size_t> here = 0;
    parallel::loop(0, pairs.size(), [&](std::size_t p) {
      if (sets.unite(pairs[p].first, pairs[p].second)) ++here;
    });
    EXPECT_EQ(here, united);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(sets.first(i), expected.first(i));
  }
}

}  // namespace
}  // namespace sectile
