// What is found out once, for several threads.
#include "parallel/once_alone.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sectile {
namespace {

TEST(OnceFlag, OfManyThreadsOneRunsTheBodyAndTheOthersWaitForItsEnd) {
  for (int round = 0; round < 100; ++round) {
    OnceFlag flag;
    int made = 0;  // not atomic: whoever comes later must see what was made
    std::vector<int> seen(8);
    std::vector<std::thread> threads;
    for (int& mine : seen)
      threads.emplace_back([&] {
        flag.run([&] {
          std::this_thread::sleep_for(std::chrono::microseconds(50));
          ++made;
        });
        mine = made;
      });
    for (std::thread& t : threads) t.join();
    EXPECT_EQ(seen, std::vector<int>(8, 1));
  }
}

TEST(OnceFlag, WhatLooksBeforeIsRunUntilItIsDone) {
  OnceFlag flag;
  int looked = 0;
  EXPECT_TRUE(flag.run_before([&] { ++looked; }));
  EXPECT_TRUE(flag.run_before([&] { ++looked; }));
  EXPECT_FALSE(flag.done());
  flag.run([] {});
  EXPECT_FALSE(flag.run_before([&] { ++looked; }));
  EXPECT_EQ(looked, 2);
}

TEST(OnceFlag, WhatThrowsIsRunAgainByTheNextThatAsks) {
  OnceFlag flag;
  int tries = 0;
  const auto body = [&] {
    if (++tries < 3) throw std::runtime_error("not yet");
  };
  EXPECT_THROW(flag.run(body), std::runtime_error);
  EXPECT_THROW(flag.run(body), std::runtime_error);
  flag.run(body);
  flag.run(body);
  EXPECT_EQ(tries, 3);
}

TEST(OnceFlag, ThoseThatWaitedForABodyThatThrewRunTheirs) {
  OnceFlag flag;
  std::atomic<int> tries{0}, failures{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      try {
        flag.run([&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
          if (++tries < 3) throw std::runtime_error("not yet");
        });
      } catch (const std::runtime_error&) {
        ++failures;
      }
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(failures, 2);
}

}  // namespace
}  // namespace sectile
