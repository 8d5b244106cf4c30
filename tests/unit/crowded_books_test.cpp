// What Booleans of books leave out matters nowhere: the same comes out with an observer, for whom
// nothing is left out.
#include <gtest/gtest.h>

#include <random>

#include "cases.h"
#include "sectile/sectile.h"
#include "unit/leaves.h"

namespace sectile {
namespace {

// Leaves anywhere, some wide, some of them slits in others, as long as they make a solid; they
// begin in one of so many places.
Solid random_book(std::mt19937& random, int count, int lows, bool sheared) {
  constexpr int turn = 192;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  PolygonMesh mesh;
  for (int made = 0, tries = 0; made < count && tries < 6 * count; ++tries) {
    const int first = below(turn), width = tries % 17 == 0 ? 20 + below(75) : 1 + below(4),
              low = below(lows);
    PolygonMesh more = mesh;
    test::add_leaf({first, (first + width) % turn, low, low + 1 + below(60), below(12) == 0},
                   sheared, more);
    if (!test::is_accepted(more)) continue;
    mesh = std::move(more);
    ++made;
  }
  return Solid::from_mesh(mesh);
}

struct Listener : Observer {
  void phase_done(Phase, const std::vector<TraceEvent>&) override {}
};

void expect_the_same_for_an_observer(const Solid& a, const Solid& b) {
  Listener listener;
  BooleanOptions observed;
  observed.observer = &listener;
  for (const Operation op : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Solid result = boolean(a, b, op), all = boolean(a, b, op, observed);
    EXPECT_TRUE(result == all);
    EXPECT_TRUE(validate(result).empty());
    EXPECT_TRUE(boolean(result, b, Operation::subtract) == boolean(all, b, Operation::subtract));
  }
}

TEST(CrowdedBooks, AreWhatTheyAreForAnObserver) {
  for (const int lows : {40, 3, 1})
    for (unsigned seed = 0; seed < cases(2u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_book(random, 45, lows, seed % 2 == 1);
      expect_the_same_for_an_observer(a, random_book(random, 45, lows, seed % 2 == 1));
    }
}

// A leaf for each part of a turn, that reaches to the next one at most; some have another one above
// them.
Solid random_chain(std::mt19937& random, int first, int lows, bool sheared) {
  constexpr int turn = 192, step = 4;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  PolygonMesh mesh;
  for (int at = first; at < first + turn; at += step) {
    const int end = at + 1 + below(step - 1), low = below(lows), high = low + 1 + below(60);
    test::add_leaf({at % turn, end % turn, low, high}, sheared, mesh);
    const int next = high + 1 + below(5);
    if (below(3) == 0)
      test::add_leaf({at % turn, end % turn, next, next + 1 + below(60)}, sheared, mesh);
  }
  return Solid::from_mesh(mesh);
}

// Each leaf of one overlaps the next one of the other, all around the line.
TEST(CrowdedBooks, OfLeavesThatOverlapAllAroundAreWhatTheyAreForAnObserver) {
  for (const int lows : {40, 3, 1})
    for (unsigned seed = 0; seed < cases(2u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_chain(random, 0, lows, seed % 2 == 1);
      expect_the_same_for_an_observer(a, random_chain(random, 2, lows, seed % 2 == 1));
    }
}

// Nothing but the sets' own laws, and volumes: no other way of the Boolean is asked.
TEST(CrowdedBooks, OfLeavesThatOverlapAllAroundObeyTheLawsOfSets) {
  for (const int lows : {40, 1})
    for (unsigned seed = 0; seed < cases(3u); ++seed) {
      SCOPED_TRACE(lows);
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const Solid a = random_chain(random, 0, lows, false),
                  b = random_chain(random, 1, lows, false),
                  both = boolean(a, b, Operation::intersect), any = boolean(a, b, Operation::unite),
                  rest = boolean(a, b, Operation::subtract);
      EXPECT_NEAR(any.volume() + both.volume(), a.volume() + b.volume(), 1e-9 * any.volume());
      EXPECT_NEAR(rest.volume() + both.volume(), a.volume(), 1e-9 * a.volume());
      EXPECT_TRUE(boolean(rest, both, Operation::unite) == a);
      EXPECT_TRUE(boolean(any, rest, Operation::subtract) == b);
      EXPECT_TRUE(boolean(rest, b, Operation::intersect).is_empty());
      for (const Solid& made : {both, any, rest}) EXPECT_TRUE(validate(made).empty());
    }
}

}  // namespace
}  // namespace sectile
