// Which shells may lie in which: none that does may be missed, and long ones that lie beside each
// other hold nothing, though all their boxes do.
#include "import/shell_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "search/bundle_order.h"

namespace sectile {
namespace {

using Corners = std::vector<Vec3>;

class Needles {
 public:
  explicit Needles(unsigned seed) : random_(seed) {}
  double number(double size) {
    return std::uniform_real_distribution<double>(-size, size)(random_);
  }
  Vec3 place(double size) { return {number(size), number(size), number(size)}; }
  /// A prism over a triangle.
  Corners prism(const Vec3& at, const Vec3& way, double width) {
    Corners corners;
    for (const Vec3& off : {Vec3{0, 0, 0}, Vec3{width, 0, 0}, Vec3{0, width, 0}})
      for (const double far : {0.0, 1.0})
        corners.push_back(
            {at.x + off.x + far * way.x, at.y + off.y + far * way.y, at.z + off.z + far * way.z});
    return corners;
  }

 private:
  std::mt19937 random_;
};

// Nearer to the middle, each corner.
Corners within(const Corners& outer, double share) {
  Vec3 middle{0, 0, 0};
  const double part = 1 / static_cast<double>(outer.size());
  for (const Vec3& p : outer)
    middle = {middle.x + part * p.x, middle.y + part * p.y, middle.z + part * p.z};
  Corners inner;
  for (const Vec3& p : outer)
    inner.push_back({middle.x + share * (p.x - middle.x), middle.y + share * (p.y - middle.y),
                     middle.z + share * (p.z - middle.z)});
  return inner;
}

ShellBoxes boxes_of(const std::vector<Corners>& shells) {
  std::vector<Box> boxes;
  for (const Corners& corners : shells) {
    Bounds bounds;
    for (const Vec3& p : corners) bounds.add(p);
    boxes.push_back(bounds.box());
  }
  return ShellBoxes(boxes, [&](std::uint32_t s) { return shells[s]; });
}

TEST(ShellBoxes, NeedlesOfAllDirectionsHoldNothing) {
  Needles needles(1);
  std::vector<Corners> shells;
  for (int i = 0; i < 200; ++i)
    shells.push_back(needles.prism(needles.place(1), needles.place(5), 1e-6));
  const ShellBoxes boxes = boxes_of(shells);
  EXPECT_EQ(boxes.held_count(), 0u);
  for (std::uint32_t s = 0; s < 200; ++s) EXPECT_FALSE(boxes.holds_any(s));
}

// All have one corner in common.
TEST(ShellBoxes, SpikesOfAFanHoldNothing) {
  Needles needles(2);
  std::vector<Corners> shells;
  for (int i = 0; i < 200; ++i) {
    const double x = needles.number(1), y = needles.number(1);
    shells.push_back({{0, 0, 0}, {x, y, 1}, {x + 1e-6, y, 1}, {x, y + 1e-6, 1}});
  }
  EXPECT_EQ(boxes_of(shells).held_count(), 0u);
}

TEST(ShellBoxes, WhatLiesInANeedleIsHeld) {
  Needles needles(3);
  std::vector<Corners> shells;
  for (int i = 0; i < 100; ++i) {
    shells.push_back(needles.prism(needles.place(1), needles.place(5), 0.01));
    shells.push_back(within(shells.back(), 0.5));
    shells.push_back(within(shells.back(), 1e-4));
  }
  const ShellBoxes boxes = boxes_of(shells);
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    EXPECT_TRUE(boxes.is_held(s) || s % 3 == 0) << s;
    EXPECT_TRUE(boxes.holds_any(s) || s % 3 == 2) << s;
  }
}

TEST(ShellBoxes, BoxesAreEnoughOfFewShells) {
  const Corners cube = {{0, 0, 0}, {4, 4, 4}}, inner = {{1, 1, 1}, {2, 2, 2}},
                beside = {{3, 3, 3}, {5, 5, 5}};
  const ShellBoxes boxes = boxes_of({inner, cube, beside});
  EXPECT_TRUE(boxes.is_held(0));
  EXPECT_FALSE(boxes.is_held(1));
  EXPECT_FALSE(boxes.is_held(2));
  EXPECT_TRUE(boxes.holds_any(1));
  EXPECT_EQ(boxes.farthest_first(), (std::vector<std::uint32_t>{2, 1, 0}));
}

// An onion with a pebble in each of its layers, whatever comes first.
TEST(ShellBoxes, WhatLiesInLayersIsHeldByAllAroundIt) {
  std::vector<Corners> shells;
  for (int layer = 1; layer <= 60; ++layer) {
    const double r = 4.0 * layer;
    shells.push_back({{-r, -r, -r}, {r, r, r}});
    shells.push_back({{r - 3, r - 3, r - 3}, {r - 1, r - 1, r - 1}});
  }
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(shells.begin(), shells.end(), random);
    const ShellBoxes boxes = boxes_of(shells);
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
      const bool is_pebble = shells[s][0].x > 0, is_outermost = shells[s][1].x == 240;
      EXPECT_EQ(boxes.is_held(s), !is_outermost);
      EXPECT_EQ(boxes.holds_any(s), !is_pebble);
    }
  }
}

TEST(BundleOrder, KeepsThoseOfOneDirectionTogether) {
  Needles needles(4);
  const std::array<Vec3, 3> ways{Vec3{9, 1, 2}, Vec3{-1, 8, 3}, Vec3{2, -3, -9}};
  std::vector<OrientedBox> boxes;
  for (std::uint32_t i = 0; i < 300; ++i)
    boxes.push_back(OrientedBox(needles.prism(needles.place(0.2), ways[i % 3], 1e-3)));
  const std::vector<std::uint32_t> order = order_in_bundles(boxes);
  ASSERT_EQ(order.size(), 300u);
  int changes = 0;
  for (std::size_t i = 1; i < order.size(); ++i) changes += order[i] % 3 != order[i - 1] % 3;
  EXPECT_EQ(changes, 2);
}

TEST(BundleOrder, OfBoxesWithoutExtentIsAnyOrderOfAll) {
  const Vec3 p{1, 2, 3};
  const std::vector<OrientedBox> same(5, OrientedBox(std::span<const Vec3>(&p, 1)));
  EXPECT_EQ(order_in_bundles(same), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace sectile
