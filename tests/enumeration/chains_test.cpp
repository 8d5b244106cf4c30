// Chains: the result of one operation is the operand of the next, without any meshing between.
#include <gtest/gtest.h>

#include <random>

#include "cases.h"
#include "cells.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

Solid unit_cell(int x, int y, int z) {
  return block({double(x), double(y), double(z)}, {x + 1.0, y + 1.0, z + 1.0});
}

void expect_cells(const Solid& solid, const CellSet& cells, int step) {
  ASSERT_EQ(solid.volume(), cells.volume()) << "step " << step;
  ASSERT_EQ(solid.area(), cells.area()) << "step " << step;
}

TEST(Chains, ChessBoardOfUnitedCellsIsTakenAwayAgain) {
  constexpr int n = 4;
  Solid solid;
  CellSet cells(n);
  int step = 0;
  for (const int parity : {0, 1})
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          if ((x + y + z) % 2 != parity) continue;
          cells.set(x, y, z, true);
          solid = boolean(solid, unit_cell(x, y, z), Operation::unite);
          expect_cells(solid, cells, ++step);
        }
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        cells.set(x, y, z, false);
        solid = boolean(solid, unit_cell(x, y, z), Operation::subtract);
        expect_cells(solid, cells, ++step);
      }
  EXPECT_TRUE(solid.is_empty());
}

TEST(Chains, RandomBlocksOfAGridStayExact) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](int below) {
      return static_cast<int>(random() % static_cast<unsigned>(below));
    };
    constexpr int n = 4;
    CellSet cells(n);
    Solid solid;
    for (int step = 0; step < 40; ++step) {
      int low[3], high[3];
      for (int k = 0; k < 3; ++k) {
        low[k] = pick(n);
        high[k] = low[k] + 1 + pick(n - low[k]);
      }
      const bool add = pick(2) == 0;
      for (int z = low[2]; z < high[2]; ++z)
        for (int y = low[1]; y < high[1]; ++y)
          for (int x = low[0]; x < high[0]; ++x) cells.set(x, y, z, add);
      const Solid tool = block({double(low[0]), double(low[1]), double(low[2])},
                               {double(high[0]), double(high[1]), double(high[2])});
      solid = boolean(solid, tool, add ? Operation::unite : Operation::subtract);
      ASSERT_EQ(solid.volume(), cells.volume()) << "seed " << seed << " step " << step;
      ASSERT_EQ(solid.area(), cells.area()) << "seed " << seed << " step " << step;
      ASSERT_TRUE(validate(solid, false).empty()) << "seed " << seed << " step " << step;
    }
  }
}

TEST(Chains, LawsOfSetAlgebraHoldExactly) {
  std::mt19937 random(7);
  for (int i = 0; i < cases(40); ++i) {
    const auto some = [&] {
      return Solid::from_mesh(CellSet::of_mask(1 + random() % 255).mesh(Meshing::triangles));
    };
    const Solid a = some(), b = some(), c = some();
    const auto unite = [](const Solid& p, const Solid& q) {
      return boolean(p, q, Operation::unite);
    };
    const auto meet = [](const Solid& p, const Solid& q) {
      return boolean(p, q, Operation::intersect);
    };
    const auto minus = [](const Solid& p, const Solid& q) {
      return boolean(p, q, Operation::subtract);
    };
    EXPECT_EQ(unite(a, a), a);
    EXPECT_EQ(meet(a, a), a);
    EXPECT_TRUE(minus(a, a).is_empty());
    EXPECT_EQ(unite(a, b), unite(b, a));
    EXPECT_EQ(unite(unite(a, b), c), unite(a, unite(b, c)));
    EXPECT_EQ(meet(a, unite(b, c)), unite(meet(a, b), meet(a, c)));
    EXPECT_EQ(unite(minus(a, b), meet(a, b)), a);
    EXPECT_EQ(unite(a, meet(a, b)), a);
    EXPECT_EQ(minus(a, unite(b, c)), meet(minus(a, b), minus(a, c)));
  }
}

}  // namespace
}  // namespace sectile::test
