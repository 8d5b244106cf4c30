// The boundary classification of figures 11 and 12, and its sums in all figures: what equation (5)
// and Table I make of the parts must be the results' boundaries.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "samples/samples.h"
#include "scenes/expectations.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

using expectations::Figure;

constexpr double tolerance = 1e-11;

TEST(EightWay, Figure11) {
  const samples::Sample sample = samples::get("fig11");
  const EightWay parts = classify(sample.a, sample.b);
  EXPECT_EQ(parts.a_in_b.faces.size(), 3u);
  EXPECT_EQ(parts.a_out_b.faces.size(), 6u);
  EXPECT_EQ(parts.b_in_a.faces.size(), 3u);
  EXPECT_EQ(parts.b_out_a.faces.size(), 6u);
  EXPECT_NEAR(parts.a_in_b.area, 12, tolerance);
  EXPECT_NEAR(parts.a_out_b.area, 84, tolerance);
  EXPECT_NEAR(parts.b_in_a.area, 12, tolerance);
  EXPECT_NEAR(parts.b_out_a.area, 84, tolerance);
  for (const SurfacePart* on :
       {&parts.a_on_b_plus, &parts.a_on_b_minus, &parts.b_on_a_plus, &parts.b_on_a_minus})
    EXPECT_TRUE(on->faces.empty());
}

// A's front is 6x2 and its top 6x4. B's leg 1x1 is flush with the front and goes through the top
// over 1x2; beside it B stands on the top over 3x2.
TEST(EightWay, Figure12) {
  const samples::Sample sample = samples::get("fig12");
  const EightWay parts = classify(sample.a, sample.b);
  EXPECT_NEAR(parts.a_in_b.area, 2, tolerance);
  EXPECT_NEAR(parts.a_on_b_plus.area, 1, tolerance);
  EXPECT_NEAR(parts.a_on_b_minus.area, 6, tolerance);
  EXPECT_NEAR(parts.a_out_b.area, 88 - 9, tolerance);
  EXPECT_NEAR(parts.b_in_a.area, 7, tolerance);
  EXPECT_NEAR(parts.b_on_a_plus.area, 1, tolerance);
  EXPECT_NEAR(parts.b_on_a_minus.area, 6, tolerance);
  EXPECT_NEAR(parts.b_out_a.area, 46 - 14, tolerance);
}

// Turned, so that no corner is three doubles, and far away beside its size: rounded coordinates
// would leave three digits of an area.
TEST(EightWay, OfSmallSolidsFarAway) {
  const double size = 0x1p-30, far = 1000;
  const Transform place = Transform::rotation_degrees({1, 2, 3}, 40) *
                          Transform::translation({far, far, far}) *
                          Transform::scaling({size, size, size});
  const Solid a = transformed(block({0, 0, 0}, {3, 3, 3}), place),
              b = transformed(block({1, 2, 2}, {2, 4, 4}), place);
  const EightWay parts = classify(a, b);
  const double face = a.area() / 6 / 9;  // of a unit cube
  for (const auto& [area, faces] : {std::pair{parts.a_out_b.area, 52},
                                    {parts.a_in_b.area, 2},
                                    {parts.b_in_a.area, 4},
                                    {parts.b_out_a.area, 12}})
    EXPECT_NEAR(area / face, faces, 1e-14 * faces);
}

class ClassificationTest : public testing::TestWithParam<const Figure*> {
 protected:
  const Figure& figure() const { return *GetParam(); }
  double area(std::size_t row) const { return figure().rows[row].area; }
  const samples::Sample sample = samples::get(GetParam()->sample);
};

TEST_P(ClassificationTest, EightPartsMakeAllFourResults) {
  const EightWay p = classify(sample.a, sample.b);
  EXPECT_NEAR(p.a_in_b.area + p.a_out_b.area + p.a_on_b_plus.area + p.a_on_b_minus.area,
              sample.a.area(), tolerance);
  EXPECT_NEAR(p.b_in_a.area + p.b_out_a.area + p.b_on_a_plus.area + p.b_on_a_minus.area,
              sample.b.area(), tolerance);
  EXPECT_NEAR(p.a_on_b_plus.area, p.b_on_a_plus.area, tolerance);
  EXPECT_NEAR(p.a_on_b_minus.area, p.b_on_a_minus.area, tolerance);
  EXPECT_NEAR(p.a_out_b.area + p.b_out_a.area + p.a_on_b_plus.area, area(0), tolerance);
  EXPECT_NEAR(p.a_in_b.area + p.b_in_a.area + p.a_on_b_plus.area, area(1), tolerance);
  EXPECT_NEAR(p.a_out_b.area + p.b_in_a.area + p.a_on_b_minus.area, area(2), tolerance);
  EXPECT_NEAR(p.b_out_a.area + p.a_in_b.area + p.b_on_a_minus.area, area(3), tolerance);
}

TEST_P(ClassificationTest, FourPartsMakeTheResult) {
  const FourWay unite = classify(sample.a, sample.b, Operation::unite);
  EXPECT_NEAR(unite.a_out_b.area + unite.b_out_a.area, area(0), tolerance);
  const FourWay intersect = classify(sample.a, sample.b, Operation::intersect);
  EXPECT_NEAR(intersect.a_in_b.area + intersect.b_in_a.area, area(1), tolerance);
  const FourWay subtract = classify(sample.a, sample.b, Operation::subtract);
  EXPECT_NEAR(subtract.a_out_b.area + subtract.b_in_a.area, area(2), tolerance);
  const FourWay turned = classify(sample.b, sample.a, Operation::subtract);
  EXPECT_NEAR(turned.a_out_b.area + turned.b_in_a.area, area(3), tolerance);
}

// Table I as corrected: where the overlaps go, seen by the eight parts' areas.
TEST_P(ClassificationTest, FollowsTableOne) {
  const EightWay p = classify(sample.a, sample.b);
  const double plus = p.a_on_b_plus.area, minus = p.a_on_b_minus.area;
  struct Row {
    Operation operation;
    double a_in, a_out, b_in, b_out;  // what the overlaps add
  };
  for (const Row& row : {Row{Operation::unite, minus, plus, plus + minus, 0},
                         Row{Operation::intersect, plus, minus, 0, plus + minus},
                         Row{Operation::subtract, plus, minus, 0, plus + minus}}) {
    const FourWay four = classify(sample.a, sample.b, row.operation);
    EXPECT_NEAR(four.a_in_b.area, p.a_in_b.area + row.a_in, tolerance);
    EXPECT_NEAR(four.a_out_b.area, p.a_out_b.area + row.a_out, tolerance);
    EXPECT_NEAR(four.b_in_a.area, p.b_in_a.area + row.b_in, tolerance);
    EXPECT_NEAR(four.b_out_a.area, p.b_out_a.area + row.b_out, tolerance);
  }
}

std::vector<const Figure*> pairs() {
  std::vector<const Figure*> result;
  for (const Figure& figure : expectations::figures())
    if (figure.rows.size() == 4) result.push_back(&figure);
  return result;
}

std::string test_name(const testing::TestParamInfo<const Figure*>& figure) {
  std::string name = figure.param->sample;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Paper, ClassificationTest, testing::ValuesIn(pairs()), test_name);

}  // namespace
}  // namespace sectile
