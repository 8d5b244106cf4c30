// Booleans that touch little of faces with very many holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "growth/steps.h"
#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

constexpr std::uint32_t sides = 32;

Solid drill(double x, double y) {
  return transformed(cylinder(0.3, 3, sides), Transform::translation({x, y, -1}));
}

struct Plate {
  Solid solid;
  std::size_t corners;  // of its holes, above and below
};

Plate plate_with_holes(int columns) {
  std::vector<Solid> holes;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j) holes.push_back(drill(i + 0.5, j + 0.5));
  return {subtract(block({0, 0, 0}, {columns + 1.0, columns + 0.0, 1}), holes),
          2 * sides * holes.size()};
}

// What every further corner of a plate adds to the steps of what is done with it. `work`: of a
// plate and its number of columns.
template <class Work>
double steps_per_corner_of(const Work& work) {
  const auto steps = [&](const Plate& plate, int columns) {
    work(plate.solid, columns);  // finds what blocks keep
    return static_cast<double>(steps_of([&] { work(plate.solid, columns); }));
  };
  constexpr int few_columns = 10, many_columns = 20;
  const Plate few = plate_with_holes(few_columns), many = plate_with_holes(many_columns);
  return (steps(many, many_columns) - steps(few, few_columns)) /
         static_cast<double>(many.corners - few.corners);
}

// Of cutting it.
template <class Tool>
double steps_per_corner(const Tool& tool) {
  return steps_per_corner_of(
      [&](const Solid& plate, int columns) { boolean(plate, tool(columns), Operation::subtract); });
}

TEST(Growth, OneMoreHoleInAPlateOfHoles) {
  EXPECT_LT(steps_per_corner([](double columns) { return drill(columns + 0.5, 1.5); }), 90);
}

TEST(Growth, AHoleThatOverlapsOneOfAPlateOfHoles) {
  EXPECT_LT(steps_per_corner([](double) { return drill(2.7, 1.5); }), 90);
}

// Both parts take their holes with them.
TEST(Growth, AThinSlotThatDividesAPlateOfHoles) {
  EXPECT_LT(steps_per_corner([](double columns) {
              return block({columns / 2 - 0.05, -1, -1}, {columns / 2 + 0.05, columns + 1, 2});
            }),
            130);
}

TEST(Growth, APlateOfHolesIsSplitBetweenThem) {
  EXPECT_LT(steps_per_corner_of([](const Solid& plate, int columns) {
              split(plate, {1, 0, 0, -columns / 2.0});  // each corner goes to one of two results
            }),
            250);
}

// A corner of it stands in a block.
TEST(Growth, APlateOfHolesIsTakenAway) {
  EXPECT_LT(steps_per_corner_of([](const Solid& plate, int) {
              boolean(block({-1, -1, -1}, {0.125, 0.125, 2}), plate, Operation::subtract);
            }),
            90);
}

// What is left has the plate's faces turned around.
TEST(Growth, AMouldOfAPlateOfHolesIsDrilled) {
  double most = 0;
  for (const Operation operation : {Operation::subtract, Operation::unite})
    most = std::max(
        most, steps_per_corner_of([&](const Solid& plate, int columns) {
          const Solid large = block({-1, -1, -1}, {columns + 2.0, columns + 1.0, 2});
          const Solid peg = transformed(drill(1, 1), Transform::translation({0, 0, -0.75}));
          boolean(boolean(large, plate, Operation::subtract), peg, operation);
        }));
  EXPECT_LT(most, 250);
}

}  // namespace
}  // namespace sectile
