// Oriented boxes of long things that lie aslant, in the order in which they are.
#include "search/oriented_index.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "search/box_index.h"

namespace sectile {
namespace {

using Stick = std::array<Vec3, 2>;

class Sticks {
 public:
  explicit Sticks(unsigned seed) : random_(seed) {}
  Vec3 place(double size) {
    std::uniform_real_distribution<double> number(-size, size);
    return {number(random_), number(random_), number(random_)};
  }
  std::vector<Stick> make(std::size_t count, double size) {
    std::vector<Stick> sticks(count);
    for (Stick& s : sticks) {
      s[0] = place(size);
      const Vec3 off = place(0.1);
      s[1] = {s[0].x + off.x + 3, s[0].y + off.y + 2, s[0].z + off.z + 1};
    }
    return sticks;
  }

 private:
  std::mt19937 random_;
};

OrientedIndex index_of(const std::vector<Stick>& sticks, double slack) {
  return OrientedIndex(sticks.size(), slack, [&](std::uint32_t i, const auto& add) {
    for (const Vec3& p : sticks[i]) add(p);
  });
}

TEST(OrientedIndex, BoxesOfAllLevelsHoldWhatIsInThem) {
  Sticks sticks(1);
  for (const std::size_t count : {1u, 4u, 5u, 16u, 17u, 70u}) {
    const std::vector<Stick> all = sticks.make(count, 5);
    const OrientedIndex index = index_of(all, 0);
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint64_t level = 0; level == 0 || std::uint64_t(1) << (2 * level) < count; ++level)
        for (const Vec3& p : all[i]) {
          const OrientedBox point(std::span<const Vec3>(&p, 1));
          EXPECT_FALSE(apart(index.at(level, i >> (2 * level)), point)) << i << ", level " << level;
        }
  }
}

TEST(OrientedIndex, FindsAllThatMeetsTogetherWithABoxIndex) {
  Sticks sticks(2);
  const std::vector<Stick> all = sticks.make(300, 2);
  std::vector<Box> boxes;
  for (const Stick& s : all) boxes.push_back(box_around(s[0], s[1]));
  const BoxIndex index(boxes, true);
  const OrientedIndex oriented = index_of(all, 0);
  std::size_t looked_at = 0, near = 0;
  for (const Stick& s : sticks.make(50, 2)) {
    const Box box = box_around(s[0], s[1]);
    const OrientedBox around{std::span<const Vec3>(s)};
    std::vector<bool> found(all.size(), false);
    index.overlapping(
        box, 300,
        [&](std::uint32_t i) {
          ++looked_at;
          return found[i] = true;
        },
        [&](std::uint64_t level, std::uint32_t i) { return apart(oriented.at(level, i), around); });
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      near += boxes[i].overlaps(box) ? 1 : 0;
      const bool meets = boxes[i].overlaps(box) && !apart(OrientedBox(all[i]), around);
      EXPECT_EQ(found[i], meets) << i;
    }
  }
  EXPECT_LT(20 * looked_at, near);
}

TEST(OrientedIndex, KeepsTheSlack) {
  const std::vector<Stick> one{{Vec3{0, 0, 0}, Vec3{3, 2, 1}}};
  const Vec3 aside{1.5, 1, 1};  // .5 above its middle
  const OrientedBox point(std::span<const Vec3>(&aside, 1));
  EXPECT_TRUE(apart(index_of(one, 0).at(0, 0), point));
  EXPECT_FALSE(apart(index_of(one, 0.6).at(0, 0), point));
}

TEST(OrientedBox, ALineAlongXComesInWhereItMeetsIt) {
  const Stick stick{Vec3{10, 0, 0}, Vec3{20, 10, 0}};
  const OrientedBox box{std::span<const Vec3>(stick)};
  EXPECT_NEAR(begin_along_x(box, {0, 5, 0}), 15, 1e-9);
  EXPECT_NEAR(begin_along_x(box, {0, 8, 0}), 18, 1e-9);
  EXPECT_NEAR(begin_along_x(box, {16, 5, 0}), 16, 1e-9);  // starts beyond it
}

}  // namespace
}  // namespace sectile
