// Checks all results of two solids by the volume that the two share.
#pragma once

#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile::test {

/// Unites, intersects and subtracts a and b in both orders: every result is legal and has the
/// volume that follows from the one they share. Volumes are equal exactly unless a tolerance for
/// their rounding is given.
inline void expect_volumes(const Solid& a, const Solid& b, double common, double tolerance = 0) {
  const double volume_a = a.volume(), volume_b = b.volume();
  const struct {
    Solid result;
    double volume;
  } cases[] = {{boolean(a, b, Operation::unite), volume_a + volume_b - common},
               {boolean(b, a, Operation::unite), volume_a + volume_b - common},
               {boolean(a, b, Operation::intersect), common},
               {boolean(b, a, Operation::intersect), common},
               {boolean(a, b, Operation::subtract), volume_a - common},
               {boolean(b, a, Operation::subtract), volume_b - common}};
  for (const auto& c : cases) {
    EXPECT_NEAR(c.result.volume(), c.volume, tolerance);
    EXPECT_TRUE(validate(c.result).empty());
  }
  EXPECT_EQ(cases[2].result.is_empty(), common == 0);
  EXPECT_EQ(cases[3].result.is_empty(), common == 0);
}

}  // namespace sectile::test
