// The paper's figures against counts found by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "samples/samples.h"
#include "scenes/expectations.h"
#include "sectile/validate.h"

namespace sectile {
namespace {

using expectations::Figure;
using expectations::Result;
using expectations::Row;

const char* name_of(Result result) {
  switch (result) {
    case Result::unite:
      return "unite";
    case Result::intersect:
      return "intersect";
    case Result::subtract:
      return "subtract";
    case Result::subtract_from:
      return "subtract_from";
    case Result::above:
      return "above";
    case Result::below:
      return "below";
  }
  return "unknown";
}

struct Case {
  const Figure* figure;
  const Row* row;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Figure& figure : expectations::figures())
    for (const Row& row : figure.rows) cases.push_back({&figure, &row});
  return cases;
}

std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name = std::string(info.param.figure->sample) + "_" + name_of(info.param.row->result);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Solid compute(const samples::Sample& sample, Result result) {
  switch (result) {
    case Result::unite:
      return boolean(sample.a, sample.b, Operation::unite);
    case Result::intersect:
      return boolean(sample.a, sample.b, Operation::intersect);
    case Result::subtract:
      return boolean(sample.a, sample.b, Operation::subtract);
    case Result::subtract_from:
      return boolean(sample.b, sample.a, Operation::subtract);
    case Result::above:
      return split(sample.a, sample.plane.value()).first;
    case Result::below:
      return split(sample.a, sample.plane.value()).second;
  }
  throw std::logic_error("no such result");
}

void expect_legal(const Solid& solid) {
  for (const Violation& violation : validate(solid)) ADD_FAILURE() << violation.what;
}

class FigureTest : public testing::TestWithParam<Case> {};

TEST_P(FigureTest, HasTheCountsFoundByHand) {
  const auto [figure, row] = GetParam();
  SCOPED_TRACE(figure->why);
  const Solid solid = compute(samples::get(figure->sample), row->result);
  expect_legal(solid);
  const SolidCounts found = solid.counts();
  EXPECT_EQ(found.vertices, row->counts.vertices);
  EXPECT_EQ(found.edges, row->counts.edges);
  EXPECT_EQ(found.faces, row->counts.faces);
  EXPECT_EQ(found.loops, row->counts.loops);
  EXPECT_EQ(found.shells, row->counts.shells);
  EXPECT_EQ(found.genus, row->counts.genus);
  EXPECT_EQ(solid.is_empty(), row->counts.faces == 0);
  EXPECT_NEAR(solid.volume(), row->volume, 1e-12 * std::max(1.0, row->volume));
  EXPECT_NEAR(solid.area(), row->area, 1e-12 * std::max(1.0, row->area));
}

INSTANTIATE_TEST_SUITE_P(Paper, FigureTest, testing::ValuesIn(all_cases()), test_name);

// The pseudomanifold of figure 3, with ends that touch themselves, is an operand again. Its two
// tops are parts of one and the same face of the block: filled again, it is the block.
TEST(Closure, TheResultOfFigure2CanBeFilled) {
  const samples::Sample sample = samples::get("fig02");
  const Solid tunnel = boolean(sample.a, sample.b, Operation::subtract);
  const Solid filled = boolean(tunnel, sample.b, Operation::unite);
  expect_legal(filled);
  EXPECT_NEAR(filled.volume(), sample.a.volume(), 1e-12);
  EXPECT_NEAR(filled.area(), sample.a.area(), 1e-12);
  EXPECT_TRUE(filled == sample.a);
  EXPECT_TRUE(boolean(tunnel, sample.b, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(tunnel, sample.b, Operation::subtract) == tunnel);
  EXPECT_TRUE(boolean(sample.a, tunnel, Operation::subtract) == sample.b);
}

// V - E + F - (L - F) = 2 (S - G): the table itself must be possible.
TEST(Expectations, SatisfyEulerPoincare) {
  for (const auto& [figure, row] : all_cases()) {
    const auto& c = row->counts;
    const auto left = static_cast<std::int64_t>(c.vertices + 2 * c.faces) -
                      static_cast<std::int64_t>(c.edges + c.loops);
    EXPECT_EQ(left, 2 * (static_cast<std::int64_t>(c.shells) - c.genus))
        << figure->sample << " " << name_of(row->result);
  }
}

// vol A + vol B = vol(A and B) + vol(A or B), and so on, within the table and against the operands.
TEST(Expectations, AgreeWithTheOperandsVolumes) {
  for (const Figure& figure : expectations::figures()) {
    const samples::Sample sample = samples::get(figure.sample);
    if (sample.plane) {
      EXPECT_NEAR(figure.rows[0].volume + figure.rows[1].volume, sample.a.volume(), 1e-12);
      continue;
    }
    ASSERT_EQ(figure.rows.size(), 4u);
    const double both = figure.rows[1].volume;
    EXPECT_NEAR(figure.rows[2].volume + both, sample.a.volume(), 1e-10) << figure.sample;
    EXPECT_NEAR(figure.rows[3].volume + both, sample.b.volume(), 1e-10) << figure.sample;
    EXPECT_NEAR(figure.rows[0].volume + both, sample.a.volume() + sample.b.volume(), 1e-10)
        << figure.sample;
  }
}

TEST(Samples, AreAllInTheTable) {
  std::set<std::string> in_table, in_samples;
  for (const Figure& figure : expectations::figures()) in_table.insert(figure.sample);
  for (const samples::Sample& sample : samples::all()) {
    EXPECT_TRUE(in_samples.insert(sample.name).second) << sample.name;
    EXPECT_NE(sample.operation.has_value(), sample.plane.has_value()) << sample.name;
    EXPECT_EQ(sample.b.is_empty(), sample.plane.has_value()) << sample.name;
  }
  EXPECT_EQ(in_table, in_samples);
}

TEST(Samples, AreLegal) {
  for (const samples::Sample& sample : samples::all()) {
    SCOPED_TRACE(sample.name);
    expect_legal(sample.a);
    expect_legal(sample.b);
  }
}

TEST(Samples, UnknownNamesThrow) {
  EXPECT_THROW(samples::get("fig99"), std::out_of_range);
}

}  // namespace
}  // namespace sectile
