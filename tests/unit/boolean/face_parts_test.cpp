// Faces that cuts divide into parts which lie within each other.
#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile {
namespace {

std::vector<Vec2> square(double x, double y, double half) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}
std::vector<Vec2> diamond(double half) {
  return {{-half, 0}, {0, -half}, {half, 0}, {0, half}};
}
Solid tube(const std::vector<Vec2>& outer, const std::vector<Vec2>& inner) {
  Profile ring;
  ring.outer = outer;
  ring.holes = {inner};
  return extrude(ring, 1);
}

// The slab's faces are cut along all walls of the tubes.
void expect_all_parts(const Solid& tubes, double area) {
  const Solid slab = block({-100, -100, 0.25}, {100, 100, 0.75});
  const Solid within = boolean(tubes, slab, Operation::intersect);
  const Solid beside = boolean(slab, tubes, Operation::subtract);
  const Solid both = boolean(slab, tubes, Operation::unite);
  for (const Solid& s : {within, beside, both}) EXPECT_TRUE(validate(s).empty());
  EXPECT_EQ(within.volume(), area / 2);
  EXPECT_EQ(beside.volume(), 20000 - area / 2);
  EXPECT_EQ(both.volume(), 20000 + area / 2);
}

TEST(FaceParts, TubesWithinTubes) {
  for (const double shift : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
    Solid tubes;
    double area = 0;
    for (int i = 1; i <= 12; ++i) {
      const double half = 4 * i;
      tubes = boolean(
          tubes, tube(square(shift * i, -shift * i, half), square(shift * i, -shift * i, half - 1)),
          Operation::unite);
      area += 4 * half * half - 4 * (half - 1) * (half - 1);
    }
    expect_all_parts(tubes, area);
  }
}

TEST(FaceParts, TubesBesideEachOtherWithinATube) {
  Solid tubes = tube(square(0, 0, 40), square(0, 0, 39));
  double area = 6400 - 78 * 78;
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      tubes = boolean(tubes, tube(square(10 * i, 10 * j, 4), square(10 * i, 10 * j, 3)),
                      Operation::unite);
      tubes = boolean(tubes, tube(square(10 * i, 10 * j, 2), square(10 * i, 10 * j, 1)),
                      Operation::unite);
      area += 64 - 36 + 16 - 4;
    }
  expect_all_parts(tubes, area);
}

TEST(FaceParts, TubesThatTouchTheNextOneInTheirEdges) {
  // Each square stands in the middles of the sides of the next one.
  Solid tubes = tube(square(0, 0, 8), diamond(8));
  tubes = boolean(tubes, tube(square(0, 0, 4), diamond(4)), Operation::unite);
  tubes = boolean(tubes, tube(square(0, 0, 2), diamond(2)), Operation::unite);
  expect_all_parts(tubes, 128 + 32 + 8);
  expect_all_parts(boolean(block({-8, -8, 0}, {8, 8, 1}), tubes, Operation::subtract), 256 - 168);
}

}  // namespace
}  // namespace sectile
