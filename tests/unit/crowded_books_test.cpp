// What Booleans of books leave out matters nowhere: the same comes out with an observer, for whom
// nothing is left out.
#include <gtest/gtest.h>

#include <random>

#include "cases.h"
#include "sectile/repair.h"
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

// Walls side by side, none of which reaches to the next one.
Solid book_of_walls(int first_direction, int count, bool of_one_length) {
  PolygonMesh mesh;
  for (int i = 0; i < count; ++i) {
    const int direction = first_direction + 2 * i, end = of_one_length ? 0 : i;
    test::add_leaf({direction, direction + 1, end % 7, 200 - end}, false, mesh);
  }
  return repair(mesh);  // knows where walls touch
}

void expect_apart(const Solid& a, const Solid& b) {
  EXPECT_EQ(boolean(a, b, Operation::subtract), a);
  EXPECT_EQ(boolean(b, a, Operation::subtract), b);
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  EXPECT_DOUBLE_EQ(boolean(a, b, Operation::unite).volume(), a.volume() + b.volume());
}

// Of the wedges between walls of one book, the widest one holds the other book.
TEST(CrowdedBooks, AreNotCutByBooksBesideThem) {
  for (const int count : {3, 45})
    for (const bool of_one_length : {true, false}) {
      SCOPED_TRACE(count);
      SCOPED_TRACE(of_one_length);
      expect_apart(book_of_walls(0, count, of_one_length),
                   book_of_walls(100, count, of_one_length));
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

}  // namespace
}  // namespace sectile
