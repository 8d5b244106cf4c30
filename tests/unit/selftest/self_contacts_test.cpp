// All pairs of triangles that meet as they must not, where very many triangles have a line in
// common: those that looking at each two of them finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "prism.h"
#include "unit/selftest/contacts_of_a_surface.h"

namespace sectile {
namespace {

// Leaves: wedges along the z axis, between two places on the rim of a square around it.
class Leaves : public test::ContactsOfASurface {
 public:
  static constexpr int places = 192;

  void add(int first, int second, int low, int high, bool inside_out) {
    std::array<PointId, 6> at;
    for (std::size_t i = 0; i < 6; ++i) {
      const double z = i < 3 ? low : high;
      const auto [x, y] =
          i % 3 == 0 ? std::array{0.0, 0.0} : on_square(i % 3 == 1 ? first : second);
      at[i] = point({x + z, y, 4 * z});
    }
    std::vector<std::array<PointId, 3>> triangles;
    for (const auto& [a, b, c] : test::prism_triangles) triangles.push_back({at[a], at[b], at[c]});
    ContactsOfASurface::add(triangles, inside_out);
  }

 private:
  static std::array<double, 2> on_square(int at) {
    constexpr int half = places / 8, side = 2 * half;
    const double along = at % side - half;
    const std::array<double, 2> corners[] = {
        {half, along}, {-along, half}, {-half, -along}, {along, -half}};
    return corners[at / side % 4];
  }
};

class LeavesOnALine : public testing::TestWithParam<int> {};  // so many ends are on the line

TEST_P(LeavesOnALine, AllThatMeetAsTheyMustNotAreNamed) {
  const int ends = GetParam();
  int some = 0, none = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Leaves leaves;
    const auto add = [&](int first, int widest, bool inside_out) {
      const int low = below(ends), high = low + 1 + below(ends - low);
      leaves.add(first, first + 1 + below(widest), low, high, inside_out);
    };
    for (int at = 0; at + 7 < Leaves::places; at += 8) add(at, 6, false);
    // Between the others, across some, in one of them, with a wall in one of theirs.
    for (int extra = below(3); extra > 0; --extra)
      add(below(160), below(2) == 0 ? 24 : 3, below(3) > 0);
    const auto expected = leaves.expected();
    ++(expected.empty() ? none : some);
    EXPECT_EQ(leaves.found(), expected);
  }
  EXPECT_GT(some, 20);
  EXPECT_GT(none, 10);
}

INSTANTIATE_TEST_SUITE_P(SelfTest, LeavesOnALine, testing::Values(1, 3, 12, 1000));

}  // namespace
}  // namespace sectile
