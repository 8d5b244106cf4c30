// A loop of the caller's that ends with an exception leaves no half solids behind: what of it still
// ran, and what it shared with others, is whole.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include "sectile/sectile.h"

namespace sectile {
namespace {

struct Stop {};

class BrokenLoop : public ::testing::Test {
 protected:
  const PolygonMesh ball_ = sphere(1, 48, 24).to_mesh();
  const Solid moved_ = transformed(sphere(1, 40, 20), Transform::translation({0.5, 0.25, 0.125}));

  Solid expected() const { return boolean(Solid::from_mesh(ball_), moved_, Operation::unite); }

  // All unions but one, which throws after a while. Those that were not begun are empty.
  std::vector<std::optional<Solid>> unite_until(std::chrono::microseconds delay,
                                                const Solid& shared) const {
    std::vector<std::optional<Solid>> made(32);
    const auto stop = std::chrono::steady_clock::now() + delay;
    const auto run = [&] {
      tbb::parallel_for(std::size_t(0), made.size(), [&](std::size_t i) {
        if (i == made.size() / 2) {
          std::this_thread::sleep_until(stop);
          throw Stop();
        }
        made[i] = boolean(Solid::from_mesh(ball_), shared, Operation::unite);
      });
    };
    EXPECT_THROW(run(), Stop);
    return made;
  }
};

TEST_F(BrokenLoop, LeavesNoHalfSolids) {
  const Solid whole = boolean(Solid::from_mesh(ball_), moved_, Operation::unite);
  std::size_t seen = 0;
  for (int k = 0; k < 6; ++k)
    for (const auto& made : unite_until(std::chrono::microseconds(3000 * k), moved_)) {
      if (!made) continue;
      ++seen;
      ASSERT_TRUE(validate(*made).empty());
      ASSERT_TRUE(*made == whole);
    }
  EXPECT_GT(seen, 6u);
}

// What is found out about a solid when it is first asked for is kept, for all who share it.
TEST_F(BrokenLoop, LeavesWhatIsSharedWhole) {
  const PolygonMesh tool = moved_.to_mesh();
  const Solid whole = boolean(Solid::from_mesh(ball_), Solid::from_mesh(tool), Operation::unite);
  for (int k = 0; k < 8; ++k) {
    const Solid shared = Solid::from_mesh(tool);
    unite_until(std::chrono::microseconds(700 * k), shared);
    ASSERT_TRUE(boolean(Solid::from_mesh(ball_), shared, Operation::unite) == whole) << k;
  }
}

}  // namespace
}  // namespace sectile
