// What Booleans leave out, and rows, matter nowhere: for an observer nothing is left out, and there
// are no rows.
#pragma once

#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "sectile/trace.h"

namespace sectile::test {

struct Listener : Observer {
  void phase_done(Phase, const std::vector<TraceEvent>&) override {}
};

inline void expect_the_same_for_an_observer(const Solid& a, const Solid& b) {
  Listener listener;
  BooleanOptions observed;
  observed.observer = &listener;
  for (const Operation op : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Solid result = boolean(a, b, op), all = boolean(a, b, op, observed);
    EXPECT_TRUE(result == all);
    EXPECT_EQ(result.counts().faces, all.counts().faces);
    EXPECT_EQ(result.counts().shells, all.counts().shells);
    EXPECT_TRUE(validate(result).empty());
    EXPECT_TRUE(boolean(result, b, Operation::subtract) == boolean(all, b, Operation::subtract));
  }
}

}  // namespace sectile::test
