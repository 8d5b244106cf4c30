// The public search by place finds all that a look at every box finds, and the nearest first.
#include "sectile/box_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace sectile {
namespace {

std::vector<Extent> random_things(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 100), size(0, 3);
  std::vector<Extent> things(count);
  for (Extent& t : things) {
    t.low = {place(random), place(random), place(random)};
    t.high = {t.low.x + size(random), t.low.y + size(random), t.low.z + size(random)};
  }
  return things;
}

TEST(BoxSearch, VisitsAllThatMeetAPlace) {
  for (const std::size_t count : {0u, 1u, 4u, 5u, 1000u}) {
    const std::vector<Extent> things = random_things(7, count);
    const BoxSearch search(things);
    EXPECT_EQ(search.empty(), count == 0);
    for (const Extent& place : random_things(8, 50)) {
      std::set<std::uint32_t> visited;
      search.near(place, [&](std::uint32_t i) { visited.insert(i); });
      for (std::uint32_t i = 0; i < count; ++i)
        EXPECT_TRUE(visited.contains(i) || !things[i].meets(place)) << count;
      EXPECT_LE(visited.size(), std::max<std::size_t>(8, count / 5)) << "it looks nearby only";
    }
  }
}

TEST(BoxSearch, KeepsWhatIsExactlyOnTheBorder) {
  // Neither has a float of its value: rounded inwards, they would be apart.
  const double x = 0.1;
  const std::vector<Extent> things = {{{0, 0, 0}, {x, 1, 1}}};
  int visits = 0;
  BoxSearch(things).near({{x, 0, 0}, {1, 1, 1}}, [&](std::uint32_t) { ++visits; });
  EXPECT_EQ(visits, 1);
}

TEST(BoxSearch, TheNearestAlongALineNeedsFewVisits) {
  // A row of a thousand walls: the line meets all of them.
  std::vector<Extent> walls;
  for (int i = 0; i < 1000; ++i) walls.push_back({{i * 1.0, 0, 0}, {i + 0.5, 1, 1}});
  const BoxSearch search(walls);
  for (const double direction : {1.0, -1.0}) {
    const Vec3 origin{direction > 0 ? -10.0 : 1010.0, 0.5, 0.5};
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    int visits = 0;
    search.along(origin, {direction, 0, 0}, 0, nearest, [&](std::uint32_t i) {
      ++visits;
      const double t = direction > 0 ? walls[i].low.x - origin.x : origin.x - walls[i].high.x;
      if (t < nearest) nearest = t, found = i;
    });
    EXPECT_EQ(found, direction > 0 ? 0u : 999u);
    EXPECT_LE(visits, 8);
  }
}

TEST(BoxSearch, AlongALineWithAMarginFindsAllBesideIt) {
  const std::vector<Extent> things = random_things(9, 500);
  const BoxSearch search(things);
  const double everywhere = std::numeric_limits<double>::infinity(), margin = 4;
  // Along an axis, so that what lies beside it is seen at once.
  std::set<std::uint32_t> visited;
  search.along({-1, 50, 50}, {1, 0, 0}, margin, everywhere,
               [&](std::uint32_t i) { visited.insert(i); });
  std::size_t beside = 0;
  for (std::uint32_t i = 0; i < things.size(); ++i) {
    const Extent& t = things[i];
    const bool near = t.low.y <= 54 && t.high.y >= 46 && t.low.z <= 54 && t.high.z >= 46;
    beside += near;
    EXPECT_TRUE(visited.contains(i) || !near) << i;
  }
  EXPECT_GT(beside, 0u);
  EXPECT_LT(visited.size(), things.size() / 4);
}

}  // namespace
}  // namespace sectile
