// Points in which very many faces meet.
#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr std::uint32_t sides = 200;

Solid cone_upwards() {
  return transformed(cone(1, 0, 1, sides), Transform::translation({0, 0, -1}));
}
Solid turned_about_apex(double degrees) {
  return transformed(cone_upwards(), Transform::rotation_degrees({1, 0, 0}, degrees));
}

void expect_exact(const Solid& a, const Solid& b, double common) {
  const Solid both = boolean(a, b, Operation::unite), inner = boolean(a, b, Operation::intersect),
              rest = boolean(a, b, Operation::subtract);
  for (const Solid& s : {both, inner, rest}) EXPECT_TRUE(validate(s).empty());
  EXPECT_NEAR(inner.volume(), common, 1e-12);
  EXPECT_NEAR(both.volume() + inner.volume(), a.volume() + b.volume(), 1e-12);
  EXPECT_NEAR(rest.volume(), a.volume() - common, 1e-12);
}

TEST(Hubs, ConesThatTouchInTheirApexes) {
  expect_exact(cone_upwards(), turned_about_apex(180), 0);
}

TEST(Hubs, ConesTurnedAboutTheirCommonApex) {
  for (const double degrees : {91.0, 100.0, 135.0})
    expect_exact(cone_upwards(), turned_about_apex(degrees), 0);
}

TEST(Hubs, ConesThatOverlapFromTheirCommonApexOn) {
  const Solid a = cone_upwards();
  for (const double degrees : {1e-9, 0.5, 30.0, 89.0}) {
    const Solid b = turned_about_apex(degrees);
    expect_exact(a, b, boolean(a, b, Operation::intersect).volume());
    EXPECT_GT(boolean(a, b, Operation::intersect).volume(), 0);
  }
}

TEST(Hubs, AConeWithinAWiderOneWithTheSameApex) {
  const Solid narrow = transformed(cone(0.5, 0, 1, sides), Transform::translation({0, 0, -1}));
  expect_exact(cone_upwards(), narrow, narrow.volume());
}

TEST(Hubs, ResultsWithSeveralVerticesInOneHubAreOperandsAgain) {
  const Solid twice = boolean(cone_upwards(), turned_about_apex(180), Operation::unite);
  expect_exact(twice, twice, twice.volume());
  const Solid crossed = turned_about_apex(90);
  expect_exact(twice, crossed, boolean(twice, crossed, Operation::intersect).volume());
}

}  // namespace
}  // namespace sectile
