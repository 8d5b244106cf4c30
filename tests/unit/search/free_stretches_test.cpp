#include "search/free_stretches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sectile {
namespace {

std::vector<std::uint32_t> taken(FreeStretches& free, std::uint32_t low, std::uint32_t high) {
  std::vector<std::uint32_t> all;
  free.take(low, high, [&](std::uint32_t s) { all.push_back(s); });
  return all;
}

using Stretches = std::vector<std::uint32_t>;

TEST(FreeStretches, EachIsTakenOnce) {
  FreeStretches free(6);
  EXPECT_EQ(taken(free, 2, 4), (Stretches{2, 3}));
  EXPECT_EQ(taken(free, 1, 6), (Stretches{1, 4, 5}));
  EXPECT_EQ(taken(free, 0, 6), (Stretches{0}));
  EXPECT_EQ(taken(free, 0, 6), Stretches());
  free.free_all();
  EXPECT_EQ(taken(free, 4, 6), (Stretches{4, 5}));
}

TEST(FreeStretches, OfNoneNothingIsTaken) {
  FreeStretches free(0);
  EXPECT_EQ(taken(free, 0, 0), Stretches());
}

TEST(FreeStretches, AreThoseThatAListOfMarksKnows) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    constexpr std::uint32_t count = 40;
    FreeStretches free(count);
    std::vector<bool> gone(count);
    for (int i = 0; i < 12; ++i) {
      const auto [low, high] = std::minmax(
          {std::uint32_t(random() % (count + 1)), std::uint32_t(random() % (count + 1))});
      Stretches expected;
      for (std::uint32_t s = low; s < high; ++s)
        if (!gone[s]) expected.push_back(s), gone[s] = true;
      EXPECT_EQ(taken(free, low, high), expected);
    }
  }
}

}  // namespace
}  // namespace sectile
