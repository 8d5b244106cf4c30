// What holds for any two solids, whatever they are.
#pragma once

#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile::test {

/// Nothing but the sets' own laws, and volumes: no other way of the Boolean is asked.
inline void expect_laws_of_sets(const Solid& a, const Solid& b) {
  const Solid both = boolean(a, b, Operation::intersect), any = boolean(a, b, Operation::unite),
              rest = boolean(a, b, Operation::subtract);
  EXPECT_NEAR(any.volume() + both.volume(), a.volume() + b.volume(), 1e-9 * any.volume());
  EXPECT_NEAR(rest.volume() + both.volume(), a.volume(), 1e-9 * a.volume());
  EXPECT_TRUE(boolean(rest, both, Operation::unite) == a);
  EXPECT_TRUE(boolean(any, rest, Operation::subtract) == b);
  EXPECT_TRUE(boolean(rest, b, Operation::intersect).is_empty());
  for (const Solid& made : {both, any, rest}) EXPECT_TRUE(validate(made).empty());
}

}  // namespace sectile::test
