#include "geometry/triangulation.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "cases.h"
#include "geometry/seen_loop.h"
#include "unit/geometry/mesh_regions.h"
#include "unit/geometry/triangulation_check.h"

namespace sectile::test {
namespace {

void expect_triangulated(const Region& region, std::size_t count) {
  const Triangles triangles = triangles_of(region), swept = swept_triangles_of(region);
  EXPECT_EQ(triangles.size(), count);
  EXPECT_EQ(swept.size(), count);
  expect_covers(region, triangles);
  expect_covers(region, swept);
  const Triangles shaped = shaped_triangles_of(region);
  expect_covers(region, shaped);
  expect_well_shaped(region, shaped);
}

Loop square(std::int64_t x, std::int64_t y, std::int64_t size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}
Loop square_hole(std::int64_t x, std::int64_t y, std::int64_t size) {
  return {{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}};
}

TEST(triangulation, small_loops) {
  expect_triangulated(Region({{{0, 0}, {4, 0}, {1, 3}}}), 1);
  expect_triangulated(Region({square(0, 0, 5)}), 2);
  expect_triangulated(Region({{{0, 0}, {4, 1}, {8, 0}, {4, 9}}}), 2);
  expect_triangulated(Region({{{0, 0}, {9, 0}, {9, 3}, {3, 3}, {3, 9}, {0, 9}}}), 4);
}

TEST(triangulation, straight_corners_are_used) {
  expect_triangulated(Region({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {0, 4}}}), 3);
  expect_triangulated(Region({{{0, 0}, {2, 0}, {4, 0}, {2, 2}, {0, 4}, {0, 3}}}), 4);
  Loop square_of_steps;
  for (int i = 0; i < 20; ++i) square_of_steps.push_back({i, 0});
  for (int i = 0; i < 20; ++i) square_of_steps.push_back({20, i});
  for (int i = 0; i < 20; ++i) square_of_steps.push_back({20 - i, 20});
  for (int i = 0; i < 20; ++i) square_of_steps.push_back({0, 20 - i});
  expect_triangulated(Region({square_of_steps}), 78);
}

TEST(triangulation, nearly_straight_corners_are_not_cut_off) {
  constexpr std::int64_t far = 1 << 24;
  Loop quad{{0, 0}, {far / 2, -1}, {far, 0}, {far / 2, far / 2}};
  for (std::size_t turn = 0; turn < quad.size(); ++turn) {
    const Region region({quad});
    Triangles triangles;
    triangulate_in_shape(region.predicates(), region.loop_ends, triangles);
    expect_covers(region, triangles);
    const auto nearly_straight = static_cast<std::uint32_t>((5 - turn) % 4);
    for (const auto& triangle : triangles)  // both end there
      EXPECT_EQ(std::count(triangle.begin(), triangle.end(), nearly_straight), 1);
    std::rotate(quad.begin(), quad.begin() + 1, quad.end());
  }
}

// Exact turns take a while.
struct CountedTurns : GridPredicates {
  std::size_t& exact_turns;
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    ++exact_turns;
    return GridPredicates::turn(i, j, k);
  }
  Sign clear_turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const std::int64_t area = area2(points[i], points[j], points[k]);
    return std::abs(area) > 1 << 26 ? sign_of_integer(area) : Sign::zero;
  }
};

TEST(triangulation, clear_ears_need_no_exact_turns) {
  constexpr std::int64_t far = 1 << 24;
  for (const std::int64_t bend : {-1, 0, 1}) {
    Loop loop{{0, 0}, {far / 4, bend}, {far / 2, 0}, {far, 0}, {far / 2, far / 2}};
    for (std::size_t turn = 0; turn < loop.size(); ++turn) {
      const Region region({loop});
      std::size_t exact_turns = 0;
      Triangles triangles;
      triangulate(CountedTurns{region.predicates(), exact_turns}, region.loop_ends, triangles);
      expect_covers(region, triangles);
      EXPECT_EQ(exact_turns, 0u);
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    }
  }
}

TEST(triangulation, what_has_no_clear_ears_is_cut_exactly) {
  const Region region({{{0, 0}, {4, 1}, {8, 0}, {4, 9}}});
  std::size_t exact_turns = 0;
  Triangles triangles;
  triangulate(CountedTurns{region.predicates(), exact_turns}, region.loop_ends, triangles);
  expect_covers(region, triangles);
  EXPECT_GT(exact_turns, 0u);
}

TEST(triangulation, holes) {
  expect_triangulated(Region({square(0, 0, 9), square_hole(3, 3, 3)}), 8);
  expect_triangulated(Region({square_hole(1, 1, 1), square(0, 0, 9), square_hole(5, 5, 2)}), 14);
}

TEST(triangulation, slits) {
  // A slit alone, one with a knee, and one that starts at a corner of the outer loop.
  expect_triangulated(Region({square(0, 0, 9), {{2, 4}, {6, 4}}}), 6);
  expect_triangulated(Region({square(0, 0, 9), {{4, 2}, {4, 6}}}), 6);
  expect_triangulated(Region({square(0, 0, 9), {{2, 2}, {6, 2}, {6, 6}, {6, 2}}}), 8);
  expect_triangulated(Region({{{0, 0}, {4, 4}, {0, 0}, {9, 0}, {9, 9}, {0, 9}}}), 4);
  // Two that cross.
  expect_triangulated(
      Region({square(0, 0, 9), {{4, 4}, {7, 4}, {4, 4}, {4, 7}, {4, 4}, {1, 4}, {4, 4}, {4, 1}}}),
      12);
  // The two sides of one slit have different corners.
  expect_triangulated(Region({square(0, 0, 9), {{1, 4}, {7, 4}, {5, 4}, {2, 4}}}), 8);
}

TEST(triangulation, loops_that_touch_in_places) {
  // Two holes, three holes in one place, a hole in a corner of the outer loop.
  expect_triangulated(Region({square(0, 0, 9), square_hole(2, 2, 2), square_hole(4, 4, 2)}), 12);
  expect_triangulated(Region({square(0, 0, 9),
                              {{4, 4}, {2, 4}, {2, 5}},
                              {{4, 4}, {4, 6}, {5, 6}},
                              {{4, 4}, {6, 3}, {4, 2}}}),
                      13);
  expect_triangulated(Region({square(0, 0, 9), {{0, 0}, {2, 4}, {4, 2}}}), 5);
}

TEST(triangulation, corners_that_touch_edges) {
  // The edge is divided if the hole lies on its left; the corner's other side is not concerned.
  expect_triangulated(Region({square(0, 0, 9), {{4, 0}, {3, 2}, {5, 2}}}), 6);
  expect_triangulated(Region({square(0, 0, 9), {{0, 4}, {2, 5}, {2, 3}}}), 6);
  expect_triangulated(Region({square(0, 0, 9), square_hole(2, 2, 4), {{4, 6}, {3, 8}, {5, 8}}}),
                      12);
  // A hole that touches all four sides leaves four triangles, which do not hang together.
  expect_triangulated(Region({square(0, 0, 8), {{4, 0}, {0, 4}, {4, 8}, {8, 4}}}), 4);
}

TEST(triangulation, edges_on_each_other_without_region_between) {
  const auto expect_area = [](const Region& region, std::size_t count) {
    std::int64_t area = 0, expected = 0;
    const Triangles triangles = triangles_of(region);
    EXPECT_EQ(triangles.size(), count);
    for (const auto& [a, b, c] : triangles) {
      EXPECT_GT(area2(region.points[a], region.points[b], region.points[c]), 0);
      area += area2(region.points[a], region.points[b], region.points[c]);
    }
    for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop) {
      expected += loop_area2(region, loop);
    }
    EXPECT_EQ(area, expected);
  };
  expect_area(Region({square(0, 0, 9), square_hole(2, 0, 3)}), 6);
  expect_area(Region({square(0, 0, 9), square_hole(6, 2, 3)}), 6);
  expect_area(Region({square(0, 0, 9), square_hole(0, 0, 3)}), 4);
  expect_area(Region({square(0, 0, 9), square_hole(2, 2, 2), square_hole(4, 2, 2)}), 10);
  expect_area(Region({square(0, 0, 9), square_hole(2, 2, 2), square_hole(4, 3, 2)}), 12);
}

TEST(triangulation, edges_without_length) {
  const Region region({{{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}, {9, 9}, {0, 9}},
                       {{2, 2}, {2, 4}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}});
  EXPECT_EQ(triangles_of(region).size(), 8u);
  EXPECT_EQ(orientation(region.predicates(), 0, 7), Sign::positive);
  EXPECT_EQ(orientation(region.predicates(), 7, 13), Sign::negative);
}

TEST(triangulation, corners_at_one_place) {
  // Corners 0 and 4 lie at one place, in two sectors. Each sector's corner is the one that the
  // sector's first edge leaves: 0 from the edge 0-1 to 6-4, and 4 from the edge 4-5 to 3-0.
  const Region region({square(0, 0, 9), {{0, 0}, {2, 4}, {4, 2}}});
  std::set<std::array<std::uint32_t, 2>> sides;
  for (const auto& [a, b, c] : triangles_of(region)) {
    sides.insert({{a, b}, {b, c}, {c, a}});
  }
  EXPECT_TRUE(sides.count({0, 1}) && sides.count({6, 0}));
  EXPECT_TRUE(sides.count({4, 5}) && sides.count({3, 4}));
}

TEST(triangulation, ears_of_loops_with_straight_corners) {
  const auto clips = [](const Loop& loop) {
    const Region region({loop});
    const GridPredicates predicates = region.predicates();
    Triangles triangles;
    const bool done = EarClipping(predicates, region.loop_ends[0]).run(triangles);
    if (done) expect_covers(region, triangles);
    return done;
  };
  EXPECT_TRUE(clips({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {0, 4}}));
  EXPECT_TRUE(clips({{2, 0}, {4, 0}, {0, 4}, {0, 0}, {1, 0}}));
  EXPECT_TRUE(clips({{0, 0}, {2, 0}, {4, 0}, {2, 2}, {0, 4}, {0, 2}}));
  EXPECT_TRUE(clips({{0, 0}, {4, 4}, {0, 0}, {9, 0}, {9, 9}, {0, 9}}));
  EXPECT_FALSE(clips(square_hole(0, 0, 4)));
}

TEST(triangulation, star_comb_and_spiral) {
  Loop star, comb, spiral;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * M_PI * i / 400, radius = i % 2 ? 1000000 : 200000;
    star.push_back(
        {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  expect_triangulated(Region({star}), 398);
  comb = {{400, -10}, {400, 0}};
  for (int i = 199; i > 0; --i) {
    comb.push_back({2 * i + 1, 1000 + i * 7 % 31});
    comb.push_back({2 * i, i % 3});
  }
  comb.push_back({0, -10});
  expect_triangulated(Region({comb}), comb.size() - 2);
  Loop inside;
  for (int i = 0; i < 600; ++i) {
    const double angle = 0.1 * i, radius = 1000 * (20 + angle);
    const auto point = [&](double r) {
      return GridPoint{std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))};
    };
    spiral.push_back(point(radius + 3000));
    inside.push_back(point(radius));
  }
  spiral.insert(spiral.end(), inside.rbegin(), inside.rend());
  expect_triangulated(Region({spiral}), 1198);
}

TEST(triangulation, refuses_what_bounds_no_region) {
  EXPECT_THROW(triangles_of(Region({square_hole(0, 0, 4)})), InternalError);
  EXPECT_THROW(triangles_of(Region({square(0, 0, 9), square(2, 2, 3)})), InternalError);
  EXPECT_THROW(triangles_of(Region({{{0, 0}, {4, 0}, {0, 3}, {4, 3}}})), InternalError);
}

class MeshRegions : public testing::TestWithParam<Tracing> {};

TEST_P(MeshRegions, random) {
  std::mt19937 random(7);
  for (int round = 0; round < cases(3000); ++round) {
    SCOPED_TRACE(round);
    const auto pick = [&random](double low, double high) {
      return std::uniform_real_distribution<>(low, high)(random);
    };
    MeshRegionOptions options;
    const double most = round % 20 == 0 ? 16 : round % 2 ? 4 : 8;
    options.width = static_cast<int>(pick(1, most));
    options.height = static_cast<int>(pick(1, most));
    options.filled = pick(0.5, 1);
    options.slits = round % 3 ? pick(0, 0.5) : 0;
    options.straightened = round % 4 ? pick(0, 1) : 1;
    options.tracing = GetParam();
    options.sheared = round % 5 != 0;
    const Region region = random_mesh_region(options, random);
    const Triangles triangles = triangles_of(region), swept = swept_triangles_of(region);
    expect_covers(region, triangles);
    expect_covers(region, swept);
    if (options.tracing == Tracing::region) {
      expect_own_corners(region, triangles);
      expect_own_corners(region, swept);
    }
    const Triangles shaped = shaped_triangles_of(region);
    expect_covers(region, shaped);
    expect_well_shaped(region, shaped);
    if (options.tracing == Tracing::region) expect_own_corners(region, shaped);
    for (std::size_t loop = 0; loop < region.loop_ends.size(); ++loop) {
      const Sign sign =
          orientation(region.predicates(), region.loop_begin(loop), region.loop_ends[loop]);
      EXPECT_EQ(sign, loop_area2(region, loop) > 0 ? Sign::positive : Sign::negative);
    }
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(triangulation, MeshRegions,
                         testing::Values(Tracing::region, Tracing::outside, Tracing::mixed),
                         [](const auto& test) {
                           return test.param == Tracing::region    ? "region"
                                  : test.param == Tracing::outside ? "outside"
                                                                   : "mixed";
                         });

TEST(triangulation, ten_thousand_holes) {
  std::mt19937 random(3);
  Region region({square(0, 0, 100000)});
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 100; ++k) {
      const auto near = [&random](std::int64_t at) {
        return at + std::uniform_int_distribution<std::int64_t>(0, 400)(random);
      };
      const std::int64_t x = 1000 * i, y = 1000 * k;
      region.add({{near(x + 10), near(y + 10)},
                  {near(x + 10), near(y + 510)},
                  {near(x + 510), near(y + 510)},
                  {near(x + 510), near(y + 10)}});
    }
  }
  const auto start = std::chrono::steady_clock::now();
  const Triangles triangles = triangles_of(region);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  RecordProperty("milliseconds", static_cast<int>(seconds.count() * 1000));
  EXPECT_EQ(triangles.size(), region.points.size() + 2 * 10000 - 2);
  expect_covers(region, triangles, false);
  const Triangles shaped = shaped_triangles_of(region);
  expect_covers(region, shaped, false);
  expect_well_shaped(region, shaped);
}

TEST(triangulation, ten_thousand_holes_in_rows) {
  Region region({square(0, 0, 30000)});
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 100; ++k) region.add(square_hole(300 * i + 100, 300 * k + 100, 100));
  }
  const Triangles triangles = triangles_of(region);
  EXPECT_EQ(triangles.size(), region.points.size() + 2 * 10000 - 2);
  expect_covers(region, triangles, false);
}

// Corners far from the origin, of whose places the last bits are lost: up to two units in the last
// place of each coordinate. Integers count these units.
TEST(seen_loop, clear_turns_are_those_of_the_places) {
  std::mt19937 random(3);
  const auto number = [&](int size) {
    return std::uniform_int_distribution<std::int64_t>(-size, size)(random);
  };
  std::map<int, int> clear, of_all;
  for (const bool behind : {false, true})
    for (const int size : {10, 40, 100, 1000, 100'000})
      for (int i = 0; i < 2000; ++i) {
        std::array<std::array<std::int64_t, 2>, 3> places;
        SeenLoop loop(2, behind);
        for (auto& [x, y] : places) {
          x = number(size);
          y = number(size);
          loop.add({0x1p20 + 0x1p-32 * double(x), -0x1p20 + 0x1p-32 * double(y), 0.3});
          x += number(2);
          y += number(2);
        }
        const auto& [a, b, c] = places;
        const std::int64_t turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        const Sign seen = loop.turn(0, 1, 2);
        ++of_all[size];
        if (seen == Sign::zero) continue;
        ++clear[size];
        EXPECT_EQ(behind ? -seen : seen, sign_of(turn)) << "size " << size;
      }
  EXPECT_GT(clear[100'000], 0.9 * of_all[100'000]);
  EXPECT_LT(clear[10], 0.5 * of_all[10]);
}

TEST(orientation, touching_loops) {
  const auto orientation_of = [](const Loop& loop) {
    const Region region({loop});
    return orientation(region.predicates(), 0, region.loop_ends[0]);
  };
  EXPECT_EQ(orientation_of(square(0, 0, 3)), Sign::positive);
  EXPECT_EQ(orientation_of(square_hole(0, 0, 3)), Sign::negative);
  // Two squares that touch in the first place of all, seen from outside and from inside.
  EXPECT_EQ(orientation_of({{0, 0}, {3, 1}, {3, 2}, {0, 0}, {2, 3}, {1, 3}}), Sign::positive);
  EXPECT_EQ(orientation_of({{0, 0}, {1, 3}, {2, 3}, {0, 0}, {3, 2}, {3, 1}}), Sign::negative);
  EXPECT_EQ(orientation_of({{0, 0}, {9, -9}, {9, 9}, {0, 0}, {4, 1}, {4, -1}}), Sign::positive);
  // A hole with a slit that reaches beyond it on the left.
  EXPECT_EQ(orientation_of({{-5, 0}, {0, 0}, {0, 3}, {3, 3}, {3, 0}, {0, 0}}), Sign::negative);
  EXPECT_EQ(orientation_of({{0, 0}, {4, 0}}), Sign::negative);
  EXPECT_EQ(orientation_of({{0, 0}, {4, 0}, {4, 5}, {4, 0}}), Sign::negative);
}

}  // namespace
}  // namespace sectile::test
