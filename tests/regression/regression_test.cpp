// What was once wrong, named by what went wrong.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "volumes.h"

namespace sectile {
namespace {

using test::expect_volumes;

// In all four right-angled positions about the z axis, as the order of the work
// depends on them.
void expect_volumes_turned(const Solid& a, const Solid& b, double common) {
  for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
    const Transform turn = Transform::rotation_degrees({0, 0, 1}, degrees);
    expect_volumes(transformed(a, turn), transformed(b, turn), common);
  }
}

Solid upside_down(const Solid& solid, double height) {
  return transformed(transformed(solid, Transform::rotation_degrees({1, 0, 0}, 180)),
                     Transform::translation({0, 0, height}));
}

const Solid plate = block({-4, -4, 0}, {4, 4, 1});

TEST(SegmentsNotDividedWhereAnOperandTouchesItself, AnApexOnAFace) {
  // A pyramid of volume 8 stands with its apex in the middle of the plate's
  // top.
  const Solid both = boolean(plate, upside_down(pyramid(2, 3, 4), 4), Operation::unite);
  EXPECT_EQ(both.volume(), 64 + 8);
  EXPECT_EQ(both.counts().shells, 2u);
  // Faces that pass through the apex, and edges that end in it or run through
  // it.
  expect_volumes_turned(both, block({-5, 0, -1}, {5, 5, 5}), 32 + 4);
  expect_volumes_turned(both, block({-5, -5, -1}, {5, 5, 1}), 64);
  expect_volumes_turned(both, block({-5, 0, 1}, {5, 5, 5}), 4);
  expect_volumes_turned(both, block({0, 0, 1}, {5, 5, 5}), 2);
  expect_volumes_turned(both, block({0, 0, 0}, {4, 4, 1}), 16);
}

TEST(SegmentsNotDividedWhereAnOperandTouchesItself, AnEdgeOnAFace) {
  // A prism along x stands with one edge on the plate's top: 1x1x2 within y
  // -1..1, z 1..2.
  Profile triangle;
  triangle.outer = {{0, 1}, {1, 2}, {-1, 2}};
  const Transform along_x{{0, 0, 1, -1, 1, 0, 0, 0, 0, 1, 0, 0}};
  const Solid prism_on_top = transformed(extrude(triangle, 2), along_x);
  const Solid both = boolean(plate, prism_on_top, Operation::unite);
  EXPECT_EQ(both.volume(), 64 + 2);
  expect_volumes_turned(both, block({-5, 0, -1}, {5, 5, 5}), 32 + 1);
  expect_volumes_turned(both, block({0, -5, -1}, {5, 5, 5}), 32 + 1);
  expect_volumes_turned(both, block({0, 0, 1}, {5, 5, 5}), 0.5);
  expect_volumes_turned(both, block({-3, -3, 0}, {3, 3, 1}), 36);
}

TEST(InnerLoopsLeftInTheWrongPartOfADividedFace, ACutDividesTheFaceAndAnotherReachesItsHole) {
  const Solid with_hole = boolean(plate, block({1, 1, -1}, {2, 2, 2}), Operation::subtract);
  const Solid across = block({-1, -5, -1}, {0, 5, 2});
  // From the hole to the rim, within the hole's wall, and around the hole.
  const Solid to_rim = block({1.5, 1.25, -1}, {5, 1.75, 2});
  const Solid bite = block({1.5, 1.25, -1}, {3, 1.75, 2});
  const Solid ring = boolean(block({0.5, 0.5, -1}, {2.5, 2.5, 2}),
                             block({0.75, 0.75, -2}, {2.25, 2.25, 3}), Operation::subtract);
  expect_volumes_turned(with_hole, boolean(across, to_rim, Operation::unite), 8 + 1);
  expect_volumes_turned(with_hole, boolean(across, bite, Operation::unite), 8 + 0.5);
  expect_volumes_turned(with_hole, boolean(across, ring, Operation::unite), 8 + 4 - 2.25);
}

TEST(InnerLoopsLeftInTheWrongPartOfADividedFace, HolesOnBothSidesOfTheCut) {
  Solid with_holes = plate;
  for (const double x : {-3.0, -1.5, 1.0, 2.5})
    with_holes =
        boolean(with_holes, block({x, -0.25, -1}, {x + 0.5, 0.25, 2}), Operation::subtract);
  EXPECT_EQ(with_holes.volume(), 63);
  const Solid across = block({-0.5, -5, -1}, {0.5, 5, 2}),
              along = block({-5, -0.125, -1}, {5, 0.125, 2});
  expect_volumes_turned(with_holes, boolean(across, along, Operation::unite),
                        8 + 7 * 0.25 - 4 * 0.5 * 0.25);
}

}  // namespace
}  // namespace sectile
