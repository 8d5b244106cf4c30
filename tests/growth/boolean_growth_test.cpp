// Booleans in which very many things meet in one place.
#include <gtest/gtest.h>

#include "boolean/boolean.h"
#include "growth/steps.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

// Each side of one cone crosses two of the other, so that all of them are cut at the apex.
TEST(Growth, ConesThatShareAnApexHalfAStepTurned) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const auto sides = static_cast<std::uint32_t>(n);
                  const Solid a = cone(1, 0, 1, sides),
                              b = transformed(a, Transform::rotation_degrees(
                                                     {0, 0, 1}, 180.0 / static_cast<double>(n)));
                  boolean_by_cutting(a, a, Operation::unite, {});  // trees
                  return [a, b] { boolean(a, b, Operation::subtract); };
                },
                500),
            n_log_n);
}

}  // namespace
}  // namespace sectile
