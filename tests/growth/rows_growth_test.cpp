// Plates in a row, along each axis: their corners lie on four lines, and each plate is behind all
// those before it.
#include <gtest/gtest.h>

#include "append_mesh.h"
#include "growth/steps.h"
#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/repair.h"

namespace sectile {
namespace {

// Two of these, one begun between the plates of the other, touch nowhere.
PolygonMesh plates(std::size_t n, int axis, double begin) {
  PolygonMesh row;
  for (std::size_t i = 0; i < n; ++i) {
    const double low = begin + 2 * static_cast<double>(i), high = low + 0.5;
    test::append((axis == 0   ? block({low, 0, 0}, {high, 1, 1})
                  : axis == 1 ? block({0, low, 0}, {1, high, 1})
                              : block({0, 0, low}, {1, 1, high}))
                     .to_mesh(),
                 row);
  }
  return row;
}

class RowGrowth : public testing::TestWithParam<int> {};

TEST_P(RowGrowth, UnionOfRowsBetweenEachOther) {
  const auto of_two = [](std::size_t n) {
    const Solid a = Solid::from_mesh(plates(n, GetParam(), 0)),
                b = Solid::from_mesh(plates(n, GetParam(), 1));
    return [=] { boolean(a, b, Operation::unite); };
  };
  EXPECT_LT(growth(of_two, 100), n_log_n);
}

TEST_P(RowGrowth, CellsOfRowsBetweenEachOther) {
  const auto of_two = [](std::size_t n) {
    const std::vector<Solid> rows{Solid::from_mesh(plates(n, GetParam(), 0)),
                                  Solid::from_mesh(plates(n, GetParam(), 1))};
    return [=] { cells(rows); };
  };
  EXPECT_LT(growth(of_two, 100), n_log_n);
}

// Each plate is a solid, and crosses the next one.
TEST_P(RowGrowth, CellsOfAsManySolids) {
  const auto of_many = [](std::size_t n) {
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < n; ++i)
      solids.push_back(Solid::from_mesh(plates(1, GetParam(), 0.3 * static_cast<double>(i))));
    return [=] { cells(solids); };
  };
  EXPECT_LT(growth(of_many, 400), n_log_n);
}

// Of what crosses itself all cells are found.
TEST_P(RowGrowth, RepairOfARowBesideBlocksThatCross) {
  for (const Rule rule : {Rule::positive, Rule::odd}) {
    const auto with_blocks = [rule](std::size_t n) {
      PolygonMesh mesh = plates(n, GetParam(), 0);
      test::append(block({-4, -4, -4}, {-2, -2, -2}).to_mesh(), mesh);
      test::append(block({-3, -3, -3}, {-1, -1, -1}).to_mesh(), mesh);
      RepairOptions options;
      options.rule = rule;
      return [=] { repair(mesh, options); };
    };
    EXPECT_LT(growth(with_blocks, 400), n_log_n);
  }
}

INSTANTIATE_TEST_SUITE_P(AlongAxis, RowGrowth, testing::Range(0, 3));

}  // namespace
}  // namespace sectile
