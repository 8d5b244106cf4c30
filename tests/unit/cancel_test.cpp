// An operation that is cancelled stops within a phase, not only after it.
#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile {
namespace {

struct Phases : Observer {
  void phase_done(Phase phase, const std::vector<TraceEvent>&) override { done.push_back(phase); }
  std::vector<Phase> done;
};

// The phases that report although the operation was cancelled as soon as it had come so far.
std::vector<Phase> phases_when_cancelled_at(double progress) {
  Phases phases;
  std::atomic<bool> cancel{false};
  BooleanOptions options;
  options.observer = &phases;
  options.cancel = &cancel;
  options.progress = [&](double done) { cancel = done >= progress; };
  const Solid a = sphere(1, 24, 12), b = block({0, 0, 0}, {2, 2, 2});
  EXPECT_THROW(boolean(a, b, Operation::unite, options), Cancelled);
  return phases.done;
}

TEST(Cancel, StopsWithinTheReduction) {
  EXPECT_TRUE(phases_when_cancelled_at(0.1).empty());
}

TEST(Cancel, StopsWithinTheNeighborhoods) {
  EXPECT_EQ(phases_when_cancelled_at(0.4), (std::vector<Phase>{Phase::reduction}));
}

TEST(Cancel, StopsWithinTheJoining) {
  const std::vector<Phase> phases = phases_when_cancelled_at(0.5);
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases.back(), Phase::null_edges);
}

}  // namespace
}  // namespace sectile
