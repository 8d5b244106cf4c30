// Arcs of directions that meet, against whole numbers.
#include "search/arc_partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace sectile {
namespace {

using Whole = std::array<std::int64_t, 3>;

Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Whole& a, const Whole& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Whole turned(const Whole& a) {
  return {-a[0], -a[1], -a[2]};
}
bool is_zero(const Whole& a) {
  return a == Whole{0, 0, 0};
}
Vec3 place(const Whole& a) {
  return {double(a[0]), double(a[1]), double(a[2])};
}

/// All directions between two.
struct Sector {
  Whole first, last;

  Whole normal() const { return cross(first, last); }
  bool contains(const Whole& direction) const {
    const Whole up = normal();
    return dot(up, direction) == 0 && dot(cross(first, direction), up) >= 0 &&
           dot(cross(direction, last), up) >= 0;
  }
  bool meets(const Sector& other) const {
    const Whole common = cross(normal(), other.normal());
    if (!is_zero(common))
      return (contains(common) && other.contains(common)) ||
             (contains(turned(common)) && other.contains(turned(common)));
    return contains(other.first) || contains(other.last) || other.contains(first) ||
           other.contains(last);
  }
  SeenArc seen() const {
    const Vec3 others[] = {place(first), place(last)};
    return SeenArc::from_point({0, 0, 0}, others);
  }
};

Sector any_sector(std::mt19937& random, int size) {
  const auto any = [&]() -> Whole {
    const auto coordinate = [&] { return std::int64_t(random() % unsigned(2 * size + 1)) - size; };
    return {coordinate(), coordinate(), coordinate()};
  };
  Sector sector;
  do sector = {any(), any()};
  while (is_zero(sector.normal()));
  return sector;
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Ascending, each as often as it was visited.
Pairs pairs_of_arcs(std::span<const SeenArc> arcs) {
  Pairs pairs;
  ArcPartition(arcs).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    pairs.push_back({i, j});
  });
  std::ranges::sort(pairs);
  return pairs;
}

std::vector<SeenArc> seen(std::span<const Sector> sectors) {
  std::vector<SeenArc> arcs;
  for (const Sector& sector : sectors) arcs.push_back(sector.seen());
  return arcs;
}

TEST(ArcPartition, FindsAllThatMeet) {
  std::mt19937 random(1);
  for (const int size : {1, 3, 100}) {
    std::vector<Sector> sectors;
    for (int i = 0; i < 150; ++i) sectors.push_back(any_sector(random, size));
    const Pairs pairs = pairs_of_arcs(seen(sectors));
    std::size_t meet = 0;
    for (std::uint32_t i = 0; i < sectors.size(); ++i)
      for (std::uint32_t j = i + 1; j < sectors.size(); ++j) {
        if (!sectors[i].meets(sectors[j])) continue;
        ++meet;
        EXPECT_TRUE(std::ranges::binary_search(pairs, std::pair(i, j))) << i << ' ' << j;
      }
    EXPECT_LT(pairs.size(), meet + meet / 8);
    EXPECT_EQ(std::ranges::adjacent_find(pairs), pairs.end());
  }
}

TEST(ArcPartition, FindsPairsOfOneOfEachOfTwoSets) {
  std::mt19937 random(2);
  std::vector<Sector> sectors;
  for (int i = 0; i < 100; ++i) sectors.push_back(any_sector(random, 2));
  const std::vector<SeenArc> arcs = seen(sectors);
  constexpr std::uint32_t half = 50;
  Pairs found, expected;
  for_each_pair_of_arcs(std::span(arcs).first(half), std::span(arcs).subspan(half),
                        [&](std::uint32_t i, std::uint32_t j) {
                          found.push_back({i, half + j});
                        });
  for (const auto& [i, j] : pairs_of_arcs(arcs))
    if (i < half && half <= j) expected.push_back({i, j});
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

// Nearly half a turn around the tip of a cone each, from one side of it to the other one, beside
// each other: no plane through the tip divides them.
TEST(ArcPartition, FindsNoneOfPlanesAroundACone) {
  constexpr int count = 2000;
  std::vector<SeenArc> arcs;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / count, x = std::cos(turn), y = std::sin(turn);
    const Vec3 ends[] = {{x - 0.1 * y, y + 0.1 * x, 2}, {-x - 0.1 * y, -y + 0.1 * x, -2}};
    arcs.push_back(SeenArc::from_point({0, 0, 0}, ends));
  }
  EXPECT_TRUE(pairs_of_arcs(arcs).empty());
}

// Of each two with one direction in common, whose sides are nearly beside each other: pointed arcs.
TEST(ArcPartition, FindsAllThinSectorsThroughOneDirection) {
  std::mt19937 random(3);
  const auto any = [&](int size) {
    const auto coordinate = [&] { return double(random() % unsigned(2 * size + 1)) - size; };
    return Vec3{coordinate(), coordinate(), coordinate()};
  };
  const auto times = [](double s, const Vec3& p) { return Vec3{s * p.x, s * p.y, s * p.z}; };
  const auto plus = [](const Vec3& p, const Vec3& q) {
    return Vec3{p.x + q.x, p.y + q.y, p.z + q.z};
  };
  const Vec3 common{320, -450, 790};
  std::vector<SeenArc> arcs;
  while (arcs.size() < 100) {
    // The common direction is that of the sum of the tip and both corners at the other end.
    const Vec3 tip = any(900), side = any(20),
               end = plus(times(double(1 + random() % 2), common), times(-0.5, tip));
    const Vec3 corners[] = {tip, plus(end, side), plus(end, times(-1, side))};
    const SeenArc arc = SeenArc::from_point({0, 0, 0}, corners);
    if (arc.is_known()) arcs.push_back(arc);
  }
  EXPECT_EQ(pairs_of_arcs(arcs).size(), arcs.size() * (arcs.size() - 1) / 2);
}

/// Half a turn from a direction over another one.
struct HalfTurn {
  Whole end, side;

  Sector first() const { return {end, side}; }
  Sector second() const { return {side, turned(end)}; }
  bool meets(const HalfTurn& other) const {
    for (const Sector& mine : {first(), second()})
      for (const Sector& across : {other.first(), other.second()})
        if (mine.meets(across)) return true;
    return false;
  }
};

TEST(ArcPartition, FindsHalfTurnsThatMeet) {
  std::mt19937 random(4);
  for (const int size : {2, 50}) {
    std::vector<HalfTurn> turns;
    std::vector<SeenArc> arcs;
    for (int i = 0; i < 150; ++i) {
      const Sector of = any_sector(random, size);
      turns.push_back({of.first, of.last});
      const Vec3 sides[] = {place(of.last)};
      arcs.push_back(SeenArc::from_edge({0, 0, 0}, place(of.first), sides));
      EXPECT_TRUE(arcs.back().is_known());
    }
    const Pairs pairs = pairs_of_arcs(arcs);
    std::size_t meet = 0;
    for (std::uint32_t i = 0; i < turns.size(); ++i)
      for (std::uint32_t j = i + 1; j < turns.size(); ++j) {
        if (!turns[i].meets(turns[j])) continue;
        ++meet;
        EXPECT_TRUE(std::ranges::binary_search(pairs, std::pair(i, j))) << i << ' ' << j;
      }
    EXPECT_LT(pairs.size(), meet + meet / 8);
  }
}

TEST(ArcPartition, FindsAllOfWhatDoublesDoNotTell) {
  const double most = 0x1p600;
  const Vec3 others[] = {{most, 0, 0}, {0, most, 0}};
  std::vector<SeenArc> arcs{SeenArc::from_point({0, 0, 0}, others)};
  EXPECT_FALSE(arcs[0].is_known());
  const Vec3 x[] = {{1, 0, 0}, {1, 1, 0}}, z[] = {{0, 0, -1}, {0, 1, -2}};
  arcs.push_back(SeenArc::from_point({0, 0, 0}, x));
  arcs.push_back(SeenArc::from_point({0, 0, 0}, z));
  EXPECT_EQ(pairs_of_arcs(arcs), (Pairs{{0, 1}, {0, 2}}));
}

TEST(SeenArc, OfHalfATurnOrMoreIsNotKnown) {
  const Vec3 around[] = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, half[] = {{1, 0, 0}, {-1, 0, 0}};
  EXPECT_FALSE(SeenArc::from_point({0, 0, 0}, around).is_known());
  EXPECT_FALSE(SeenArc::from_point({0, 0, 0}, half).is_known());
}

// Far from the origin, where doubles tell little of what is small.
TEST(SeenArc, KnowsItsError) {
  const auto corner = [](double far, double size) {
    const Vec3 others[] = {{far + size, far, far}, {far, far + size, far}};
    return SeenArc::from_point({far, far, far}, others);
  };
  EXPECT_LT(corner(0, 1).radius(1), 1e-13);
  EXPECT_GT(corner(0x1p30, 0x1p-10).radius(1), 1e-5);
  EXPECT_FALSE(corner(0x1p50, 1).is_known());
}

}  // namespace
}  // namespace sectile
