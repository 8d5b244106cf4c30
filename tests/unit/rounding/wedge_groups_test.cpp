// Wedges around an edge, in whole numbers: which have directions in common is known by cross
// products.
#include "rounding/wedge_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "cases.h"
#include "unit/rounding/half_planes.h"

namespace sectile {
namespace {

using test::cross;
using test::Direction;

// Wedges are less than half a turn, from right to left.
struct Wedge {
  Direction right, left;
  bool has(const Direction& d) const { return cross(right, d) >= 0 && cross(d, left) >= 0; }
};
// One of two arcs that have something in common begins within the other one.
bool have_some_in_common(const Wedge& a, const Wedge& b) {
  return a.has(b.right) || b.has(a.right);
}

class Around {
 public:
  Around(std::mt19937& random, int count) {
    low_ = geometry_.add_point({0, 0, -3});
    high_ = geometry_.add_point({0, 0, 40});
    const auto coordinate = [&] { return static_cast<int>(random() % 15) - 7; };
    while (wedges.size() < static_cast<std::size_t>(count)) {
      const Wedge w{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
      if (cross(w.right, w.left) > 0 && 2 * cross(w.right, w.left) < 15) add(w);
    }
    kernel_.refresh();
  }

  std::vector<WedgeGroup> groups() const { return groups_of_wedges(kernel_, 2, with_planes_); }

  std::vector<Wedge> wedges;

 private:
  void add(const Wedge& w) {
    const auto face = static_cast<std::uint32_t>(2 * wedges.size());
    const PointId left = point(w.left), right = point(w.right);
    with_planes_.push_back(
        {{face, geometry_.add_plane(PlaneDefinition::through(low_, high_, left)), left},
         {face + 1, geometry_.add_plane(PlaneDefinition::through(high_, low_, right)), right}});
    wedges.push_back(w);
  }
  PointId point(const Direction& d) { return geometry_.add_point({1.0 * d.x, 1.0 * d.y, 5}); }

  Geometry geometry_;
  Kernel kernel_{geometry_};
  PointId low_, high_;
  std::vector<EdgeSectors::Wedge> with_planes_;
};

// Per wedge, the least one with which it hangs together.
std::vector<std::uint32_t> least_together(const std::vector<Wedge>& wedges) {
  std::vector<std::uint32_t> least;
  for (std::uint32_t i = 0; i < wedges.size(); ++i) least.push_back(i);
  for (std::size_t times = 0; times < wedges.size(); ++times)
    for (std::size_t i = 0; i < wedges.size(); ++i)
      for (std::size_t j = 0; j < wedges.size(); ++j)
        if (have_some_in_common(wedges[i], wedges[j])) least[i] = std::min(least[i], least[j]);
  return least;
}

// Is there a direction in none of them, just after one of their sides?
bool are_all_around(const std::vector<Wedge>& wedges) {
  return std::ranges::all_of(wedges, [&](const Wedge& w) {
    return std::ranges::any_of(wedges, [&](const Wedge& other) {
      return cross(other.right, w.left) >= 0 && cross(w.left, other.left) > 0;
    });
  });
}

TEST(WedgeGroups, HaveAllThatHangsTogether) {
  std::array<int, 2> seen{};
  for (int seed = 0; seed < cases(300); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Around around(random, 1 + seed % 25);
    const std::vector<WedgeGroup> groups = around.groups();
    ++seen[groups.empty() ? 0 : 1];
    EXPECT_EQ(groups.empty(), are_all_around(around.wedges));
    const std::vector<std::uint32_t> least = least_together(around.wedges);
    std::vector<std::uint32_t> all, first;
    for (const WedgeGroup& group : groups) {
      first.push_back(least[group.wedges[0]]);
      for (const std::uint32_t i : group.wedges) {
        all.push_back(i);
        EXPECT_EQ(least[i], first.back());
      }
    }
    EXPECT_EQ(all.size(), groups.empty() ? 0 : around.wedges.size());
    for (std::vector<std::uint32_t>* each : {&all, &first}) {
      std::ranges::sort(*each);
      EXPECT_EQ(std::ranges::adjacent_find(*each), each->end());
    }
  }
  EXPECT_GT(seen[0], cases(10));
  EXPECT_GT(seen[1], cases(100));
}

// Nothing of the group is beyond them.
TEST(WedgeGroups, GoFromTheirFirstRightSideToTheirLastLeftOne) {
  for (int seed = 0; seed < cases(100); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Around around(random, 1 + seed % 12);
    for (const WedgeGroup& group : around.groups()) {
      const Direction right = around.wedges[group.all.right.face / 2].right,
                      left = around.wedges[group.all.left.face / 2].left;
      for (const std::uint32_t i : group.wedges) {
        const Wedge& w = around.wedges[i];
        EXPECT_TRUE(!w.has(right) || cross(w.right, right) == 0);
        EXPECT_TRUE(!w.has(left) || cross(left, w.left) == 0);
      }
    }
  }
}

TEST(WedgeGroups, AreNoneWithoutWedges) {
  std::mt19937 random(1);
  EXPECT_TRUE(Around(random, 0).groups().empty());
}

}  // namespace
}  // namespace sectile
