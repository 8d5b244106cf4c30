// A cavity whose edge touches an outer face from within: the face has a slit, an inner loop of two
// edges at one place.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "volumes.h"

namespace sectile {
namespace {

using test::expect_volumes;

Solid block_with_slit() {
  const Solid bar = transformed(prism(1, 4, 4), Transform::translation({4, 6, 7}) *
                                                    Transform::rotation_degrees({1, 0, 0}, 90));
  return boolean(block({0, 0, 0}, {8, 8, 8}), bar, Operation::subtract);
}

TEST(Slit, IsLegal) {
  const Solid a = block_with_slit();
  EXPECT_EQ(a.volume(), 504);
  EXPECT_TRUE(validate(a).empty());
  EXPECT_EQ(a.counts().loops, a.counts().faces + 1);
}

TEST(Slit, BlocksAcrossItInAllWays) {
  const Solid a = block_with_slit();
  // From beside the slit over its line to across it; inside, flush, and through the whole face.
  expect_volumes(a, block({4, -1, 6}, {9, 4, 9}), 30);
  expect_volumes(a, block({3.5, -1, 6}, {9, 4, 9}), 32.5);
  expect_volumes(a, block({2, -1, 6}, {9, 4, 9}), 44);
  expect_volumes(a, block({2, 3, 7.5}, {6, 5, 9}), 3.5);
  for (const double x : {2.0, 3.5, 4.0}) {
    expect_volumes(a, block({x, -1, 8}, {9, 4, 9}), 0);
    expect_volumes(a, block({x, 1, 8}, {9, 9, 9}), 0);
  }
}

TEST(Slit, ItselfAndItsTurnedCopies) {
  const Solid a = block_with_slit();
  expect_volumes(a, a, 504);
  const Solid shifted = transformed(a, Transform::translation({0, 2, 0}));
  expect_volumes(a, shifted, boolean(a, shifted, Operation::intersect).volume());
  const auto about_centre = Transform::translation({4, 4, 8}) *
                            Transform::rotation_degrees({0, 0, 1}, 90) *
                            Transform::translation({-4, -4, -8});
  const Solid turned = transformed(a, about_centre);
  // They share 16 / 3, so that sums round.
  expect_volumes(a, turned, boolean(a, turned, Operation::intersect).volume(), 1e-12);
  const Solid mirrored =
      transformed(a, Transform::translation({0, 0, 16}) * Transform::scaling({1, 1, -1}));
  expect_volumes(a, mirrored, 0);
}

}  // namespace
}  // namespace sectile
