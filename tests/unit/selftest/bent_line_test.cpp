// All pairs of triangles that meet as they must not, where very many walls have the edges of a bent
// line in common: those that looking at each two of them finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "cases.h"
#include "unit/leaves.h"
#include "unit/selftest/contacts_of_a_surface.h"

namespace sectile {
namespace {

// Walls that are tetrahedra, of which one edge is part of the line.
class WallsAlongABentLine : public test::ContactsOfASurface {
 public:
  static constexpr int corners = 18, directions = 192;

  /// `far`: from the line to the opposite edges of walls, where it is bent by a few units.
  WallsAlongABentLine(unsigned seed, double far) : random_(seed), far_(far) {
    for (int k = 0; k < corners; ++k)
      line_.push_back(point({double(below(3)), double(below(3)), 16.0 * k}));
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  struct Wall {
    int first, second;       // directions
    int low, high;           // corners of the line
    bool is_divided = true;  // at all corners between them
    bool inside_out = false;
  };
  /// Short ones, and long ones.
  std::array<int, 2> part() {
    const int most = below(2) == 0 ? 3 : corners - 1;
    const int low = below(corners - 1), other = std::min(corners - 1, low + 1 + below(most));
    return below(2) == 0 ? std::array{low, other} : std::array{below(3), corners - 1 - below(3)};
  }
  void add(const Wall& wall) {
    const PointId a = beside(wall.first), b = beside(wall.second);
    std::vector<std::array<PointId, 3>> triangles;
    const int step = wall.is_divided ? 1 : wall.high - wall.low;
    for (int k = wall.low; k < wall.high; k += step) {
      const PointId from = at(k), to = at(k + step);
      triangles.push_back({to, from, a});
      triangles.push_back({from, to, b});
    }
    triangles.push_back({a, at(wall.low), b});
    triangles.push_back({at(wall.high), a, b});
    // The direction of an edge may be that to the other corner.
    if (std::ranges::none_of(triangles, [&](const auto& t) { return has_no_area(t); }))
      ContactsOfASurface::add(triangles, wall.inside_out);
  }

 private:
  PointId at(int corner) const { return line_[static_cast<std::size_t>(corner)]; }
  PointId beside(int direction) {
    const auto [x, y] = test::on_square(direction);
    return point({far_ * x, far_ * y, 16.0 * below(corners) + below(3)});
  }

  std::mt19937 random_;
  double far_;
  std::vector<PointId> line_;
};

class SelfTestOfABentLine : public testing::TestWithParam<double> {};

TEST_P(SelfTestOfABentLine, AllThatMeetAsTheyMustNotAreNamed) {
  int some = 0, none = 0;
  for (unsigned seed = 0; seed < cases(36u); ++seed) {
    SCOPED_TRACE(seed);
    WallsAlongABentLine walls(seed, GetParam());
    const auto add = [&](int first, int widest, bool is_divided, bool inside_out) {
      const auto [low, high] = walls.part();
      walls.add({first, first + 1 + walls.below(widest), low, high, is_divided, inside_out});
    };
    for (int at = 0; at + 7 < WallsAlongABentLine::directions; at += 8) add(at, 6, true, false);
    // Between the others, across some, beside the line, in one of them.
    for (int extra = walls.below(3); extra > 0; --extra)
      add(walls.below(160), walls.below(2) == 0 ? 24 : 3, walls.below(3) > 0, walls.below(4) == 0);
    const auto expected = walls.expected();
    ++(expected.empty() ? none : some);
    EXPECT_EQ(walls.found(), expected);
  }
  EXPECT_GT(some, cases(10));
  if (GetParam() > 1000) {
    EXPECT_GT(none, cases(5));
  }
}

INSTANTIATE_TEST_SUITE_P(SelfTest, SelfTestOfABentLine, testing::Values(1, 16, 0x1p20));

}  // namespace
}  // namespace sectile
