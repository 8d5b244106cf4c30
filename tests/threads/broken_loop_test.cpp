// A loop of the caller's that ends with an exception leaves no half solids behind: what of it still
// ran, and what it shared with others, is whole.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include "sectile/sectile.h"
#include "threads/workers.h"

namespace sectile {
namespace {

struct Stop {};

class BrokenLoop : public ::testing::Test {
 protected:
  const PolygonMesh ball_ = sphere(1, 32, 16).to_mesh();
  const Solid moved_ = transformed(sphere(1, 28, 14), Transform::translation({0.5, 0.25, 0.125}));

  // All unions but one, which throws when `before` of the others are done and `delay` has passed:
  // others are under way then. Those that were not begun are empty.
  std::vector<std::optional<Solid>> unite_until(std::size_t before, std::chrono::microseconds delay,
                                                const Solid& shared) const {
    std::vector<std::optional<Solid>> made(32);
    std::atomic<std::size_t> done = 0;
    const auto run = [&] {
      tbb::parallel_for(std::size_t(0), made.size(), [&](std::size_t i) {
        if (i == made.size() / 2) {
          while (done < before) std::this_thread::yield();
          std::this_thread::sleep_for(delay);
          throw Stop();
        }
        made[i] = boolean(Solid::from_mesh(ball_), shared, Operation::unite);
        ++done;
      });
    };
    EXPECT_THROW(run(), Stop);
    return made;
  }
};

TEST_F(BrokenLoop, LeavesNoHalfSolids) {
  SECTILE_NEEDS_WORKERS;
  const Solid whole = boolean(Solid::from_mesh(ball_), moved_, Operation::unite);
  std::size_t seen = 0;
  for (int k = 0; k < 6; ++k)
    for (const auto& made : unite_until(2, std::chrono::microseconds(700 * k), moved_)) {
      if (!made) continue;
      ++seen;
      ASSERT_TRUE(validate(*made).empty());
      ASSERT_TRUE(*made == whole);
    }
  EXPECT_GE(seen, 12u);
}

// What is found out about a solid when it is first asked for is kept, for all who share it.
TEST_F(BrokenLoop, LeavesWhatIsSharedWhole) {
  SECTILE_NEEDS_WORKERS;
  const PolygonMesh tool = moved_.to_mesh();
  const Solid whole = boolean(Solid::from_mesh(ball_), Solid::from_mesh(tool), Operation::unite);
  for (int k = 0; k < 8; ++k) {
    const Solid shared = Solid::from_mesh(tool);
    unite_until(0, std::chrono::microseconds(300 * k), shared);
    ASSERT_TRUE(boolean(Solid::from_mesh(ball_), shared, Operation::unite) == whole) << k;
  }
}

}  // namespace
}  // namespace sectile
