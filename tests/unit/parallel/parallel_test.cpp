#include "parallel/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "parallel/scratch.h"
#include "parallel/sort.h"

namespace sectile {
namespace {

TEST(Parallel, ALoopHasEachNumberOnce) {
  for (const std::size_t grain : {1u, 7u, 100u, 5000u}) {
    std::vector<std::atomic<int>> times(1000);
    parallel::loop(parallel::Range<std::uint32_t>(17, 1000, grain), [&](const auto& part) {
      EXPECT_FALSE(part.empty());
      for (std::uint32_t i = part.begin(); i < part.end(); ++i) ++times[i];
    });
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], i < 17 ? 0 : 1) << i;
  }
}

TEST(Parallel, ALoopOverNothingCallsNobody) {
  parallel::loop(5, 5, [](std::size_t) { FAIL(); });
  parallel::loop(5, 4, [](std::size_t) { FAIL(); });
}

TEST(Parallel, WhatIsThrownInALoopLeavesIt) {
  EXPECT_THROW(parallel::loop(0, 1000,
                              [](std::size_t i) {
                                if (i == 500) throw std::runtime_error("of 500");
                              }),
               std::runtime_error);
}

TEST(Parallel, LoopsWithinLoopsRunToTheirEnd) {
  std::atomic<int> count = 0;
  parallel::loop(0, 20, [&](std::size_t) { parallel::loop(0, 50, [&](std::size_t) { ++count; }); });
  EXPECT_EQ(count, 1000);
}

TEST(Parallel, ReducingJoinsAllParts) {
  std::vector<std::uint64_t> numbers(100000);
  std::iota(numbers.begin(), numbers.end(), 1);
  const std::uint64_t sum = parallel::reduce(
      parallel::Range<std::size_t>(0, numbers.size(), 16), std::uint64_t(0),
      [&](const auto& part, std::uint64_t start) {
        for (std::size_t i = part.begin(); i < part.end(); ++i) start += numbers[i];
        return start;
      },
      std::plus<>());
  EXPECT_EQ(sum, 100000ull * 100001 / 2);
}

TEST(Parallel, TwoPiecesOfWorkAreBothDone) {
  int first = 0, second = 0;
  parallel::invoke([&] { first = 1; }, [&] { second = 2; });
  EXPECT_EQ(first + second, 3);
}

TEST(Parallel, IsolatedWorkIsDoneAndMayThrow) {
  int done = 0;
  parallel::isolate([&] { ++done; });
  EXPECT_EQ(done, 1);
  EXPECT_THROW(parallel::isolate([] { throw std::runtime_error("alone"); }), std::runtime_error);
}

TEST(Parallel, SortingPutsManyAndFewInOrder) {
  std::mt19937 random(7);
  for (const std::size_t size : {0u, 1u, 499u, 500u, 100000u}) {
    std::vector<std::uint32_t> numbers(size);
    for (std::uint32_t& n : numbers) n = std::uint32_t(random());
    std::vector<std::uint32_t> sorted = numbers;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    parallel::sort(numbers.begin(), numbers.end(), std::greater<>());
    EXPECT_EQ(numbers, sorted);
  }
}

TEST(Parallel, NobodyElseHasWhatIsLent) {
  parallel::Scratch<std::vector<std::size_t>> scratch;
  parallel::loop(0, 5000, [&](std::size_t i) {
    scratch.lend([&](std::vector<std::size_t>& mine) { mine.push_back(i); });
  });
  std::vector<std::size_t> all;
  scratch.for_each([&](const auto& one) { all.insert(all.end(), one.begin(), one.end()); });
  std::sort(all.begin(), all.end());
  ASSERT_EQ(all.size(), 5000u);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], i);
}

TEST(Alone, AThreadRunsItsLoopsByItself) {
  const auto self = std::this_thread::get_id();
  const parallel::Alone alone(true);
  int parts = 0;
  parallel::loop(parallel::Range<std::size_t>(0, 100000), [&](const auto& part) {
    EXPECT_EQ(std::this_thread::get_id(), self);
    EXPECT_EQ(part.begin(), 0u);
    EXPECT_EQ(part.end(), 100000u);
    ++parts;
  });
  EXPECT_EQ(parts, 1);
  std::vector<int> numbers(10000);
  std::iota(numbers.rbegin(), numbers.rend(), 0);
  parallel::sort(numbers.begin(), numbers.end());
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
}

TEST(Alone, EndsWithItsScopeAlsoWhereSomethingIsThrown) {
  EXPECT_FALSE(parallel::Alone::now());
  try {
    const parallel::Alone alone(true);
    EXPECT_TRUE(parallel::Alone::now());
    parallel::loop(0, 10, [](std::size_t) { throw std::runtime_error("of a loop"); });
  } catch (const std::runtime_error&) {
  }
  EXPECT_FALSE(parallel::Alone::now());
}

TEST(Alone, WhatIsFoundOutOnceHasAllThreads) {
  const parallel::Alone alone(true);
  parallel::isolate([] { EXPECT_FALSE(parallel::Alone::now()); });
  EXPECT_TRUE(parallel::Alone::now());
}

TEST(Alone, IsOneThreadOnly) {
  const parallel::Alone alone(true);
  std::thread([] { EXPECT_FALSE(parallel::Alone::now()); }).join();
}

}  // namespace
}  // namespace sectile
