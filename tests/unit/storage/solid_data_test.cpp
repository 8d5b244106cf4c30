// What a solid keeps beside its boundary, asked for by many threads at a time.
#include "storage/solid_data.h"

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <future>
#include <iostream>
#include <thread>

#include "sectile/sectile.h"

namespace sectile {
namespace {

// A thread that waits for itself cannot be freed: the test program ends.
template <class Work>
void within_a_minute(const Work& work) {
  std::future<void> done = std::async(std::launch::async, work);
  if (done.wait_for(std::chrono::minutes(1)) == std::future_status::ready) return done.get();
  std::cerr << "A parallel loop waits for itself." << std::endl;
  std::_Exit(1);
}

void loop_of_naps(int naps) {
  tbb::parallel_for(0, naps, 1,
                    [](int) { std::this_thread::sleep_for(std::chrono::microseconds(100)); });
}

// Of eight tasks one asks. The others have loops of their own; their threads take up parts of what
// the asking one does in parallel, and while it waits for these it is free for a task that asks.
template <class Ask>
void ask_in_parallel(const Ask& ask) {
  within_a_minute([&] {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
    tbb::task_arena arena(8);
    arena.execute([&] {
      tbb::parallel_for(0, 64, [&](int i) {
        if (i % 8 == 0) return ask();
        loop_of_naps(8 + i % 8);
      });
    });
  });
}

TEST(SolidData, WhatIsMadeOnceByAParallelLoopIsAskedForInAParallelLoop) {
  for (int round = 0; round < 50; ++round) {
    const SolidData data;
    std::atomic<int> made{0};
    ask_in_parallel([&] {
      data.complement([&] {
        ++made;
        loop_of_naps(64);
        return std::make_shared<const SolidData>();
      });
    });
    EXPECT_EQ(made, 1);
  }
}

TEST(SolidData, OneFreshToolIsUnitedWithAndTakenFromManyBlocksInAParallelLoop) {
  for (int round = 0; round < 3; ++round) {
    const Solid tool = sphere(1, 200, 100);
    ask_in_parallel([&] {
      const Solid body = block({0, 0, 0.99}, {2, 2, 2});
      EXPECT_LT(boolean(body, tool, Operation::subtract).volume(), body.volume());
      EXPECT_EQ(boolean(block({2, 2, 2}, {3, 3, 3}), tool, Operation::unite).counts().shells, 2u);
    });
  }
}

}  // namespace
}  // namespace sectile
