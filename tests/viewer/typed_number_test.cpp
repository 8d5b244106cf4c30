// Numbers as people type them.
#include "app/typed_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sectile::viewer {
namespace {

double length(const std::string& text) {
  return typed_number(text, Quantity::length);
}

std::string refusal(const std::string& text, Quantity quantity) {
  try {
    typed_number(text, quantity);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(TypedNumber, IsTheDoubleNearestToWhatWasTyped) {
  EXPECT_EQ(length("0.1"), 0.1);
  EXPECT_EQ(length(" -12.5e-3 "), -0.0125);
  EXPECT_EQ(length("20,5"), 20.5);
  EXPECT_EQ(length("1e12"), 1e12);
  EXPECT_EQ(length(".5"), 0.5);
  for (const double value : {1.0 / 3, 1e300, 5e-324, -0.1, 123456789.123456789})
    EXPECT_EQ(length(shortest(value)), value) << shortest(value);
}

TEST(TypedNumber, CalculatesWithBracketsAndSigns) {
  EXPECT_EQ(length("40/2"), 20);
  EXPECT_EQ(length("2 + 3 * 4 - -1"), 15);
  EXPECT_EQ(length("(2 + 3) * -4"), -20);
  EXPECT_EQ(length("100/3"), 100.0 / 3);
  EXPECT_EQ(length("0.1 + 0.2"), 0.3) << "rounded once, at the end";
  EXPECT_EQ(length("7 \u2212 2 \u00D7 3"), 1);
}

TEST(TypedNumber, KnowsUnits) {
  EXPECT_EQ(length("3 mm"), 3);
  EXPECT_EQ(length("2cm + 5mm"), 25);
  EXPECT_EQ(length("1 in"), 25.4);
  EXPECT_EQ(length("(3 + 1/8) in"), 79.375);
  EXPECT_EQ(length("0.5\""), 12.7);
  EXPECT_EQ(length("1 m"), 1000);
  EXPECT_EQ(typed_number("90\u00B0", Quantity::angle), 90);
  EXPECT_EQ(typed_number("pi rad", Quantity::angle), 180);
  EXPECT_EQ(typed_number("50 %", Quantity::plain), 0.5);
}

TEST(TypedNumber, RefusesInSentences) {
  EXPECT_EQ(refusal("", Quantity::length), "A number is missing.");
  EXPECT_EQ(refusal("abc", Quantity::length), "\"abc\" is not a number.");
  EXPECT_EQ(refusal("40/", Quantity::length), "A number is missing at the end.");
  EXPECT_EQ(refusal("1/0", Quantity::length), "Nothing can be divided by zero.");
  EXPECT_EQ(refusal("(1", Quantity::length), "A closing bracket is missing.");
  EXPECT_EQ(refusal("1.000,5", Quantity::length),
            "Use one decimal point or comma, and no marks between thousands.");
  EXPECT_EQ(refusal("3 deg", Quantity::length), "\"deg\" is not a unit of length.");
  EXPECT_EQ(refusal("12 apples", Quantity::length), "\"apples\" cannot be read.");
  EXPECT_EQ(refusal("1e999*1e999", Quantity::length), "That is no finite number.");
  EXPECT_EQ(refusal(std::string(100000, '('), Quantity::length),
            "That is too many brackets or signs.");
}

}  // namespace
}  // namespace sectile::viewer
