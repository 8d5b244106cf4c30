// Pairs of crowds: Booleans against the cells of one arrangement of all faces, which leaves nothing
// out, against the laws of sets, and written and read back. In builds with SECTILE_SMALL_CROWDS
// these few go all the ways that are made for very many.
#include "crowds.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

#include "cases.h"
#include "operations.h"
#include "sectile/arrangement.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"
#include "sectile/transform.h"
#include "unit/exact_mesh_checker.h"
#include "unit/same_shape.h"

namespace sectile::test {
namespace {

struct Cells {
  Cells(const Solid& a, const Solid& b) {
    for (const SolidCell& cell : cells(std::array{a, b}))
      (cell.operands.size() == 2 ? both : cell.operands[0] == 0 ? only_a : only_b) = cell.solid;
  }
  Solid only_a, only_b, both;
};

void expect_written(const Solid& solid, const Rounding& rounding) {
  const RoundedMesh rounded = rounded_mesh(solid, rounding);
  EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
  if (!rounding.separate_touching) {
    EXPECT_EQ(shape_fault(solid, rounded), "");
  }
}

class PairsOfCrowds {
 public:
  PairsOfCrowds(unsigned seed, int most_parts) : random_(seed), most_parts_(most_parts) {}

  // Some are of two kinds.
  void expect_next(const KindOfCrowd& kind) {
    const int parts = 4 + below(most_parts_ - 3);
    const Solid made_a = crowd(kind, parts);
    const Solid made_b = crowd(below(3) == 0 ? any_kind() : kind, parts);
    const Transform move = any_move();
    const Solid a = transformed(made_a, move);
    const Solid b = transformed(made_b, below(4) == 0 ? any_move() : move);
    expect_what_cells_are(a, b);
  }

  // The same crowd, from which something was cut, or to which something was added; or two such.
  void expect_next_versions(const KindOfCrowd& kind) {
    const Solid made = transformed(crowd(kind, 4 + below(most_parts_ - 3)), any_move());
    const Solid a = below(3) == 0 ? version_of(made) : made;
    expect_what_cells_are(a, version_of(made));
  }

 private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  const KindOfCrowd& any_kind() { return kinds_of_crowds()[random_() % kinds_of_crowds().size()]; }
  Solid crowd(const KindOfCrowd& kind, int parts) {
    return repair(CrowdOfFaces(random_).make(kind.kind, parts));
  }
  Transform any_move() {
    switch (below(4)) {
      case 0:
        return Transform();
      case 1:
        return Transform::rotation_degrees({1, 2, 3}, 40);
      case 2: {
        const double x = below(5), y = below(5), angle = below(360);
        return Transform::rotation_degrees({x, y, 1}, angle);
      }
      default:
        return Transform::scaling({1, 3, 0.1}) * Transform::rotation_degrees({1, 1, 3}, 17);
    }
  }

  Solid version_of(const Solid& solid) {
    const Solid other = transformed(crowd(any_kind(), 1 + below(4)), any_move());
    switch (below(4)) {
      case 0:
        return unite(solid, other);
      case 1:
        return minus(other, solid);
      default:
        return minus(solid, other);
    }
  }

  void expect_what_cells_are(const Solid& a, const Solid& b) {
    const Cells parts(a, b);
    const Solid all = unite(a, b), common = meet(a, b), a_rest = minus(a, b);
    EXPECT_EQ(a_rest, parts.only_a);
    EXPECT_EQ(minus(b, a), parts.only_b);
    EXPECT_EQ(common, parts.both);
    EXPECT_EQ(minus(all, b), parts.only_a);
    EXPECT_EQ(minus(all, common), unite(parts.only_a, parts.only_b));
    const double sum = a.volume() + b.volume();
    EXPECT_NEAR(all.volume() + common.volume(), sum, 1e-9 * sum);
    const std::array<const Solid*, 3> results{&all, &common, &a_rest};
    for (const Solid* solid : results) EXPECT_TRUE(validate(*solid).empty());
    const Rounding rounding = any_rounding();
    expect_written(*results[random_() % results.size()], rounding);
  }
  Rounding any_rounding() {
    Rounding rounding;
    if (below(2) == 0) rounding.numbers = Rounding::Numbers::floats;
    rounding.separate_touching = below(3) == 0;
    return rounding;
  }

  std::mt19937 random_;
  int most_parts_;
};

using ExpectNext = void (PairsOfCrowds::*)(const KindOfCrowd&);

void expect_pairs(const KindOfCrowd& kind, ExpectNext expect_next, unsigned first_seed,
                  unsigned count, int most_parts) {
  for (unsigned seed = first_seed; seed < first_seed + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PairsOfCrowds pairs(seed, most_parts);
    (pairs.*expect_next)(kind);
    if (testing::Test::HasFailure()) return;
  }
}

class Crowds : public testing::TestWithParam<KindOfCrowd> {};
class CrowdsExhaustive : public Crowds {};

std::string name_of(const testing::TestParamInfo<KindOfCrowd>& kind) {
  return kind.param.name;
}

TEST_P(Crowds, AreWhatTheirCellsAre) {
  expect_pairs(GetParam(), &PairsOfCrowds::expect_next, 1, cases(9u), 12);
}

TEST_P(Crowds, BesideVersionsOfThemselves) {
  expect_pairs(GetParam(), &PairsOfCrowds::expect_next_versions, 1, cases(6u), 12);
}

TEST_P(CrowdsExhaustive, AreWhatTheirCellsAre) {
  expect_pairs(GetParam(), &PairsOfCrowds::expect_next, 100, 12, 30);
}

TEST_P(CrowdsExhaustive, BesideVersionsOfThemselves) {
  expect_pairs(GetParam(), &PairsOfCrowds::expect_next_versions, 100, 8, 30);
}

INSTANTIATE_TEST_SUITE_P(All, Crowds, testing::ValuesIn(kinds_of_crowds()), name_of);
INSTANTIATE_TEST_SUITE_P(All, CrowdsExhaustive, testing::ValuesIn(kinds_of_crowds()), name_of);

}  // namespace
}  // namespace sectile::test
