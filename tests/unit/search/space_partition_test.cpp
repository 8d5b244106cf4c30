// What meets in a point is found, whatever planes divide it, and of what lies beside each other
// little is.
#include "search/space_partition.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace sectile {
namespace {

using Rod = SpacePartition::Rod;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Vec3 sum(const Vec3& p, double times, const Vec3& d) {
  return {p.x + times * d.x, p.y + times * d.y, p.z + times * d.z};
}

Pairs found(const SpacePartition& space, std::size_t cells) {
  Pairs pairs;
  for (const SpacePartition::Cell& cell : space.cells(cells))
    space.for_each_pair(cell,
                        [&](std::uint32_t i, std::uint32_t j) { pairs.insert(std::minmax(i, j)); });
  return pairs;
}

std::vector<std::uint32_t> no_labels(std::size_t count) {
  return std::vector<std::uint32_t>(count, SpacePartition::no_label);
}

// Triangles, long and thin or not, through points that several of them have in common.
class Through {
 public:
  explicit Through(unsigned seed) : random_(seed) {}

  void make(std::size_t count, double unit) {
    std::vector<Vec3> points(count / 4);
    for (Vec3& p : points) p = vector(1000);
    for (std::size_t i = 0; i < count; ++i) {
      at.push_back(random_() % points.size());
      label.push_back(random_() % 3 > 0 ? SpacePartition::no_label : random_() % 5);
      const Vec3 &p = points[at[i]], d = vector(20);
      const Vec3 corners[] = {sum(p, number(40) + 40, d), sum(p, number(40) - 40, d),
                              sum(p, 1, vector(random_() % 4 == 0 ? 400 : 1))};
      std::vector<Vec3> scaled;
      for (const Vec3& c : corners) scaled.push_back({unit * c.x, unit * c.y, unit * c.z});
      rods.push_back(Rod(scaled));
    }
  }

  std::vector<Rod> rods;
  std::vector<std::size_t> at;  // per triangle: one point that it holds
  std::vector<std::uint32_t> label;

 private:
  double number(int most) {
    return static_cast<int>(random_() % static_cast<unsigned>(2 * most + 1)) - most;
  }
  Vec3 vector(int most) { return {number(most), number(most), number(most)}; }

  std::mt19937 random_;
};

void expect_all_that_meet(double unit) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Through through(seed);
    through.make(1200, unit);
    const SpacePartition space(through.rods, through.label);
    const Pairs pairs = found(space, seed == 1 ? 1 : 64);
    for (std::uint32_t i = 0; i < through.at.size(); ++i)
      for (std::uint32_t j = i + 1; j < through.at.size(); ++j) {
        const bool alike =
            through.label[i] != SpacePartition::no_label && through.label[i] == through.label[j];
        if (alike) {
          EXPECT_FALSE(pairs.contains({i, j}));
        } else if (through.at[i] == through.at[j]) {
          EXPECT_TRUE(pairs.contains({i, j}));
        }
      }
  }
}

TEST(SpacePartition, FindsWhatMeets) {
  expect_all_that_meet(1);
}

TEST(SpacePartition, FindsWhatMeetsInRoundedPlaces) {
  expect_all_that_meet(1 / 3.0);
}

TEST(SpacePartition, FindsWhatMeetsWhateverTheNumbersAre) {
  for (const double unit : {0x1p-1060, 0x1p-600, 0x1p300, 0x1p490, 0x1p1000})
    expect_all_that_meet(unit);
}

TEST(SpacePartition, LooksAtFewOfManyLayersOfRodsThatLieAcrossEachOther) {
  constexpr int layers = 30;
  std::vector<Rod> rods;
  for (int layer = 0; layer < layers; ++layer)
    for (int i = 0; i < layers; ++i) {
      const Vec3 along = layer % 2 == 0 ? Vec3{0.6, 0.8, 0.3} : Vec3{-0.8, 0.6, 0.3},
                 across = layer % 2 == 0 ? Vec3{-0.8, 0.6, 0.1} : Vec3{0.6, 0.8, 0.1};
      const Vec3 from = sum({0, 0, 0.1 * layer}, i, across);
      const Vec3 to = sum(from, layers, along);
      rods.push_back(Rod(std::vector{from, to, sum(to, 0.001, across)}));
    }
  const SpacePartition space(rods, no_labels(rods.size()));
  EXPECT_LT(found(space, 1).size(), 40 * rods.size());
}

TEST(SpacePartition, LooksAtFewOfTwoFansThatReachIntoEachOther) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random() % 1000000) / 1e6; };
  const Vec3 hubs[] = {{0, 0, 0}, {0.1, 0.2, 1}};
  std::vector<Rod> rods;
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec3 &hub = hubs[i % 2], &other = hubs[1 - i % 2];
    const Vec3 end = sum(other, 1, {number(), number(), 0});
    rods.push_back(Rod(std::vector{hub, end, sum(end, 1e-8, {1, 0, 0})}));
    labels.push_back(i % 2);
  }
  EXPECT_LT(found(SpacePartition(rods, labels), 16).size(), 30 * rods.size());
}

TEST(SpacePartition, OfNothingAndOfOne) {
  EXPECT_TRUE(found(SpacePartition({}, {}), 4).empty());
  EXPECT_TRUE(found(SpacePartition({Rod(std::vector{Vec3{1, 2, 3}})}, no_labels(1)), 4).empty());
}

}  // namespace
}  // namespace sectile
