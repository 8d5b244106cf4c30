// A solid that is turned by arbitrary angles and cut, again and again, is the same as one that is
// cut once all is in place: by other points, other planes and other products of matrices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "sectile/sectile.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

struct Step {
  Transform turn;
  Solid tool;  ///< taken away after the turn
};

std::vector<Step> random_steps(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Step> steps;
  for (int i = 0; i < count; ++i) {
    const Vec3 axis{number(random), number(random), number(random)};
    const Transform turn = Transform::rotation_degrees(axis, 360 * number(random));
    const double side = 2.2 - 0.6 * std::abs(number(random));
    steps.push_back({turn, block({side, -3, -3}, {4, 3, 3})});
  }
  return steps;
}

const Solid& cube() {
  static const Solid solid = block({-2, -2, -2}, {2, 2, 2});
  return solid;
}

Solid cut_step_by_step(const std::vector<Step>& steps) {
  Solid body = cube();
  for (const Step& step : steps)
    body = boolean(transformed(body, step.turn), step.tool, Operation::subtract);
  return body;
}

Solid cut_in_the_end(const std::vector<Step>& steps) {
  Solid body = cube();
  std::vector<Solid> tools;
  for (const Step& step : steps) {
    body = transformed(body, step.turn);
    for (Solid& tool : tools) tool = transformed(tool, step.turn);
    tools.push_back(step.tool);
  }
  for (const Solid& tool : tools) body = boolean(body, tool, Operation::subtract);
  return body;
}

// Of how many doubles a number is the sum.
int doubles_in(const Dyadic& number) {
  int count = 0;
  for (Dyadic rest = number; rest.sign() != Sign::zero; ++count) {
    const std::int64_t power = rest.magnitude();
    rest -= Dyadic(rest.scaled(-power).nearest()).scaled(power);
  }
  return count;
}

int longest_number(const Solid& solid) {
  const Geometry& geometry = solid.data()->geometry();
  int longest = 0;
  for (std::size_t f = 0; f < geometry.frames.size(); ++f)
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        longest = std::max(longest, doubles_in(geometry.frames[f]->exact(row, column)));
  return longest;
}

void expect_the_same_both_ways(int count) {
  const std::vector<Step> steps = random_steps(count, 5);
  const Solid body = cut_step_by_step(steps);
  // Products of so many matrices of doubles, whose exponents are some bits apart.
  const int longest = longest_number(body);
  testing::Test::RecordProperty("longest_number_in_doubles", longest);
  EXPECT_GE(longest, 9 * count / 10);
  EXPECT_LE(longest, 13 * count / 10);
  for (const Violation& v : validate(body)) ADD_FAILURE() << v.what;
  EXPECT_TRUE(body == cut_in_the_end(steps));
  EXPECT_FALSE(body == cut_step_by_step({steps.begin() + 1, steps.end()}));
}

TEST(TurnsAndCuts, FortyAreTheSameBothWays) {
  expect_the_same_both_ways(40);
}

TEST(TurnsAndCutsExhaustive, TwoHundredAreTheSameBothWays) {
  expect_the_same_both_ways(200);
}

}  // namespace
}  // namespace sectile
