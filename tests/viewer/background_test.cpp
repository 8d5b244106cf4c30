// Work in the background: the newest request wins, results are taken once, whatever ends wakes.
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "events/background.h"

namespace sectile::viewer {
namespace {

std::atomic<int> wakes{0};

class BackgroundTest : public testing::Test {
 protected:
  void SetUp() override {
    wakes = 0;
    set_wake([] {
      ++wakes;
      wakes.notify_all();
    });
  }
  void TearDown() override { set_wake(nullptr); }
};

TEST_F(BackgroundTest, WakesTheWindowWhenItsWorkIsDone) {
  Background<int, int> worker([](int n, WorkState&) { return std::optional(2 * n); });
  worker.request(21);
  wakes.wait(0);  // without it this test does not end
  EXPECT_EQ(worker.take(), 42);
}

TEST_F(BackgroundTest, WakesWhenItsWorkWasCancelledToo) {
  std::atomic<bool> runs{false};
  Background<int, int> worker([&](int, WorkState& state) -> std::optional<int> {
    runs = true;
    while (!state.cancelled()) std::this_thread::yield();
    return std::nullopt;
  });
  worker.request(1);
  while (!runs) std::this_thread::yield();
  worker.request(2);
  wakes.wait(0);
  EXPECT_EQ(worker.take(), std::nullopt);
}

TEST_F(BackgroundTest, IsBusyUntilItsResultIsTaken) {
  Background<int, int> worker([](int n, WorkState&) { return std::optional(n); });
  EXPECT_FALSE(worker.is_busy());
  worker.request(7);
  worker.wait();
  EXPECT_FALSE(worker.is_working());
  EXPECT_TRUE(worker.is_busy());
  EXPECT_EQ(worker.take(), 7);
  EXPECT_FALSE(worker.is_busy());
  EXPECT_EQ(worker.take(), std::nullopt);
}

TEST_F(BackgroundTest, TheNewestRequestWins) {
  std::promise<void> go;
  const std::shared_future<void> gate = go.get_future();
  std::atomic<int> runs{0};
  Background<int, int> worker([&](int n, WorkState&) {
    gate.wait();
    ++runs;
    return std::optional(n);
  });
  for (int n = 0; n < 100; ++n) worker.request(n, std::chrono::hours(1));
  go.set_value();
  worker.wait();
  EXPECT_EQ(worker.take(), 99);
  EXPECT_LE(runs, 2);
}

TEST_F(BackgroundTest, EndsWhateverItDoes) {
  Background<int, int> worker([](int, WorkState& state) -> std::optional<int> {
    while (!state.cancelled()) std::this_thread::yield();
    return std::nullopt;
  });
  worker.request(1);
  worker.request(2, std::chrono::hours(1));
}

}  // namespace
}  // namespace sectile::viewer
