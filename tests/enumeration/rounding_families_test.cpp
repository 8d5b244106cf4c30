// The results of whole families of Booleans, scaled and turned, are legal once they are rounded.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "boundary.h"
#include "operations.h"
#include "sectile/sectile.h"
#include "unit/exact_mesh_checker.h"
#include "unit/manifold_check.h"
#include "unit/same_shape.h"

namespace sectile::test {
namespace {

using Numbers = Rounding::Numbers;

std::string fault_of(const Solid& solid, const Rounding& rounding) {
  const RoundedMesh rounded = rounded_mesh(solid, rounding);
  const std::string fault = ExactMeshChecker(rounded.mesh).verdict();
  return fault.empty() ? shape_fault(solid, rounded) : fault;
}

// In doubles, floats, and on a grid that is hardly finer than the cells.
std::vector<std::string> faults_of(const Solid& solid, const std::string& name) {
  std::vector<std::string> faults;
  for (const Numbers numbers : {Numbers::doubles, Numbers::floats, Numbers::grid}) {
    Rounding rounding;
    rounding.numbers = numbers;
    rounding.spacing = 0.125;
    if (const std::string fault = fault_of(solid, rounding); !fault.empty())
      faults.push_back(name + " numbers " + std::to_string(int(numbers)) + ": " + fault);
  }
  return faults;
}

Transform placement(Mask mask) {
  const double angle = 17 + 0.7 * double(mask % 97), size = 0.3 + 0.01 * double(mask % 31);
  return Transform::rotation_degrees({1, 0.3, 0.1 * double(mask % 7)}, angle) *
         Transform::scaling({size, size * 1.1, size * 0.9});
}

Solid cells_of(const Complex& cubes, Mask mask) {
  return Solid::from_mesh(Boundary(cubes, mask).mesh(Meshing::shared));
}

// The cells are turned before the operation, so that nothing of the result has its place.
void expect_results_legal(Mask first_a, Mask step_a, Mask step_b) {
  const Complex cubes = Complex::cubes(2);
  for (Mask a = first_a; a < 256; a += step_a) {
    const Transform place = placement(a);
    const Solid solid_a = transformed(cells_of(cubes, a), place);
    for (Mask b = 1 + a % step_b; b < 256; b += step_b) {
      const Solid solid_b = transformed(cells_of(cubes, b), place);
      for (const Operation operation : all_operations) {
        const std::string name =
            std::to_string(a) + " " + name_of(operation) + " " + std::to_string(b);
        EXPECT_EQ(faults_of(boolean(solid_a, solid_b, operation), name),
                  std::vector<std::string>{});
      }
    }
  }
}

TEST(RoundingFamilies, SomePairsOfCells) {
  expect_results_legal(7, 83, 41);
}

TEST(RoundingFamiliesExhaustive, AllSetsOfCells) {
  const Complex cubes = Complex::cubes(2);
  for (Mask mask = 1; mask < 256; ++mask)
    EXPECT_EQ(faults_of(transformed(cells_of(cubes, mask), placement(mask)), std::to_string(mask)),
              std::vector<std::string>{});
}

TEST(RoundingFamiliesExhaustive, AllSetsOfCellsAsManifolds) {
  const Complex cubes = Complex::cubes(2);
  for (Mask mask = 1; mask < 256; ++mask)
    for (const bool turned : {false, true})
      for (const Numbers numbers : {Numbers::doubles, Numbers::floats, Numbers::grid}) {
        const Solid cells = cells_of(cubes, mask);
        Rounding rounding;
        rounding.numbers = numbers;
        rounding.spacing = 0x1p-10;
        rounding.separate_touching = true;
        const Solid solid = turned ? transformed(cells, placement(mask)) : cells;
        const RoundedMesh rounded = rounded_mesh(solid, rounding);
        SCOPED_TRACE(std::to_string(mask) + " numbers " + std::to_string(int(numbers)));
        EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
        EXPECT_EQ(manifold_fault(rounded.mesh), "");
        EXPECT_EQ(shape_fault(solid, rounded), "");
      }
}

TEST(RoundingFamiliesExhaustive, EveryNinetySeventhPairOfCells) {
  expect_results_legal(1, 1, 97);
}

// One set turned by a little more than the other one: slivers everywhere.
TEST(RoundingFamiliesExhaustive, PairsOfCellsTurnedByALittle) {
  const Complex cubes = Complex::cubes(2);
  for (Mask a = 1; a < 256; a += 2) {
    const Solid solid_a = transformed(cells_of(cubes, a), placement(a));
    const Mask b = (a * 37) % 255 + 1;
    const double little = std::pow(10.0, -1.0 - double(a % 15));
    const Solid solid_b = transformed(transformed(cells_of(cubes, b), placement(a)),
                                      Transform::rotation_degrees({0.2, 1, 0.5}, little));
    for (const Operation operation : all_operations)
      EXPECT_EQ(faults_of(boolean(solid_a, solid_b, operation),
                          std::to_string(a) + " " + name_of(operation) + " " + std::to_string(b)),
                std::vector<std::string>{});
  }
}

// Exported after each step.
TEST(RoundingFamiliesExhaustive, ChainOfTwoHundredCubes) {
  const Solid cube = block({-1, -1, -1}, {1, 1, 1});
  Solid all = cube;
  for (int i = 1; i <= 200; ++i) {
    const Transform place =
        Transform::translation({0.9 * i, 0.3 * std::sin(i), 0.2 * std::cos(0.7 * i)}) *
        Transform::rotation_degrees({1, 0.1 * (i % 11), 0.7}, 21.3 * i);
    all = boolean(all, transformed(cube, place), Operation::unite);
    // All that is new is near the end: the rest is looked at now and then.
    const Solid end = i % 50 == 0 ? all
                                  : boolean(all, block({0.9 * i - 6, -4, -4}, {0.9 * i + 4, 4, 4}),
                                            Operation::intersect);
    EXPECT_EQ(faults_of(end, std::to_string(i)), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace sectile::test
