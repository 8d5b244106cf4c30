// The tree finds exactly what comparing all boxes with all boxes finds, each pair once.
#include "search/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace sectile {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class Boxes {
 public:
  explicit Boxes(unsigned seed) : random_(seed) {}
  /// Small integer corners, so that many boxes touch without overlapping otherwise.
  std::vector<Box> make(std::size_t count, int range, int size) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes)
      for (int k = 0; k < 3; ++k) {
        box.low[k] = static_cast<float>(below(range));
        box.high[k] = box.low[k] + static_cast<float>(below(size));
      }
    return boxes;
  }
  std::vector<std::uint32_t> groups(std::size_t count, int kinds) {
    std::vector<std::uint32_t> groups(count);
    for (auto& g : groups) {
      const int kind = below(kinds + 1);
      g = kind == kinds ? BoxTree::no_group : static_cast<std::uint32_t>(kind);
    }
    return groups;
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 random_;
};

bool overlap(const Box& p, const Box& q) {
  for (int k = 0; k < 3; ++k)
    if (p.low[k] > q.high[k] || q.low[k] > p.high[k]) return false;
  return true;
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class Skip>
Pairs found_by_comparison(const std::vector<Box>& a, const std::vector<Box>& b, const Skip& skip) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j)
      if (overlap(a[i], b[j]) && !skip(i, j)) pairs.emplace_back(i, j);
  return pairs;
}

void expect_all_pairs(const std::vector<Box>& a, const std::vector<Box>& b) {
  Pairs found;
  BoxTree::overlaps(BoxTree(a), BoxTree(b),
                    [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
  EXPECT_EQ(sorted(found),
            found_by_comparison(a, b, [](std::uint32_t, std::uint32_t) { return false; }));
}

TEST(BoxTree, FindsThePairsThatComparingAllFinds) {
  Boxes boxes(1);
  for (const std::size_t m : {1u, 2u, 4u, 5u, 17u, 300u})
    for (const std::size_t n : {1u, 3u, 8u, 64u, 257u})
      for (const int range : {1, 6, 100})
        for (const int size : {1, 3, 40})
          expect_all_pairs(boxes.make(m, range, size), boxes.make(n, range, size));
}

TEST(BoxTree, FindsPairsOfClumpsFarFromEachOther) {
  Boxes boxes(2);
  std::vector<Box> a = boxes.make(100, 5, 3), b = boxes.make(100, 5, 3);
  for (std::size_t i = 0; i < 50; ++i)
    for (int k = 0; k < 3; ++k) {
      a[i].low[k] += 1e30f;
      a[i].high[k] += 1e30f;
      b[i].low[k] -= 1e-30f;
    }
  expect_all_pairs(a, b);
}

TEST(BoxTree, FindsNothingInAnEmptyTree) {
  Boxes boxes(3);
  const BoxTree none, some(boxes.make(10, 4, 4));
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.level_count(), 0u);
  EXPECT_FALSE(some.empty());
  int visits = 0;
  const auto count = [&](std::uint32_t, std::uint32_t) { ++visits; };
  BoxTree::overlaps(none, some, count);
  BoxTree::overlaps(some, none, count);
  none.query([](const Box&) { return true; }, [&](std::uint32_t) { ++visits; });
  EXPECT_EQ(visits, 0);
}

TEST(BoxTree, QueriesFindTheItemsAroundAPoint) {
  Boxes boxes(4);
  const std::vector<Box> a = boxes.make(500, 20, 6);
  const BoxTree tree(a);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{boxes.below(52) / 2.0, boxes.below(52) / 2.0, boxes.below(52) / 2.0};
    std::vector<std::uint32_t> found, wanted;
    tree.query([&](const Box& box) { return box.contains(p); },
               [&](std::uint32_t item) { found.push_back(item); });
    for (std::uint32_t k = 0; k < a.size(); ++k)
      if (a[k].contains(p)) wanted.push_back(k);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, wanted);
  }
}

TEST(BoxTree, KnowsWhetherAnyBoxOverlapsAnother) {
  Boxes boxes(9);
  EXPECT_FALSE(BoxTree().overlaps_any(Box::everything()));
  int overlap_any = 0;
  for (const std::size_t count : {1u, 4u, 5u, 17u, 100u}) {
    const std::vector<Box> a = boxes.make(count, 30, 8);
    const BoxTree tree(a);
    for (const Box& b : boxes.make(200, 30, 8)) {
      const bool any = std::ranges::any_of(a, [&](const Box& box) { return overlap(box, b); });
      EXPECT_EQ(tree.overlaps_any(b), any);
      overlap_any += any;
    }
  }
  EXPECT_GT(overlap_any, 100);
  EXPECT_LT(overlap_any, 900);
}

// The nearest item is found first, and so most are never looked at.
TEST(BoxTree, QueriesInOrderFindAllAndTheNearestFirst) {
  Boxes boxes(8);
  for (const std::size_t count : {1u, 4u, 5u, 9u, 500u}) {
    const std::vector<Box> a = boxes.make(count, 100, 4);
    const BoxTree tree(a);
    std::vector<std::uint32_t> found;
    const auto low = [&](BoxTree::Node n) { return tree.box(n).low[0]; };
    const auto before = [&](BoxTree::Node n, BoxTree::Node m) { return low(n) < low(m); };
    struct All {
      bool operator()(BoxTree::Node) const { return true; }
      bool operator()(const Box&) const { return true; }
    };
    tree.query_in_order(All(), before, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(found, all);

    struct NotBeyond {
      const BoxTree& tree;
      float& end;
      bool operator()(BoxTree::Node n) const { return (*this)(tree.box(n)); }
      bool operator()(const Box& box) const { return box.low[0] < end; }
    };
    float end = std::numeric_limits<float>::infinity();
    std::size_t visited = 0;
    tree.query_in_order(NotBeyond{tree, end}, before, [&](std::uint32_t i) {
      ++visited;
      end = std::min(end, a[i].low[0]);
    });
    const auto lowest = std::min_element(
        a.begin(), a.end(), [](const Box& b, const Box& c) { return b.low[0] < c.low[0]; });
    EXPECT_EQ(end, lowest->low[0]);
    EXPECT_LE(visited, 12u);
  }
}

TEST(BoxTree, SkipsExactlyThePairsOfUnwantedGroups) {
  Boxes boxes(5);
  for (const int kinds : {1, 2, 7})
    for (int i = 0; i < 20; ++i) {
      const std::vector<Box> a = boxes.make(120, 8, 4), b = boxes.make(90, 8, 4);
      const auto of_a = boxes.groups(a.size(), kinds), of_b = boxes.groups(b.size(), kinds);
      const auto skip = [](std::uint32_t g, std::uint32_t h) { return (g + h) % 2 == 0; };
      Pairs found;
      BoxTree::overlaps(
          BoxTree(a, of_a), BoxTree(b, of_b),
          [&](std::uint32_t p, std::uint32_t q) { found.emplace_back(p, q); }, skip);
      EXPECT_EQ(sorted(found), found_by_comparison(a, b, [&](std::uint32_t p, std::uint32_t q) {
                  return of_a[p] != BoxTree::no_group && of_b[q] != BoxTree::no_group &&
                         skip(of_a[p], of_b[q]);
                }));
    }
}

TEST(BoxTree, QueriesSkipExactlyTheItemsOfUnwantedGroups) {
  Boxes make(4);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Box> boxes = make.make(static_cast<std::size_t>(make.below(60)), 10, 6);
    const std::vector<std::uint32_t> group = make.groups(boxes.size(), 3);
    const Box around = make.make(1, 10, 6).front();
    const auto is_skipped = [](std::uint32_t g) { return g != 1; };
    std::vector<std::uint32_t> found, expected;
    BoxTree(boxes, group)
        .query([&](const Box& b) { return overlap(b, around); },
               [&](std::uint32_t i) { found.push_back(i); }, is_skipped);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (overlap(boxes[i], around) && (group[i] == BoxTree::no_group || !is_skipped(group[i])))
        expected.push_back(i);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(BoxTree, FindsItsOwnPairsButThoseWithinOneGroup) {
  Boxes boxes(7);
  for (const int kinds : {1, 3, 40})
    for (const std::size_t count : {1u, 4u, 5u, 130u, 500u}) {
      const std::vector<Box> a = boxes.make(count, 12, 5);
      const auto group = boxes.groups(count, kinds);
      const BoxTree tree(a, group);
      Pairs found;
      for (const auto& part : tree.self_parts(16))
        tree.self_overlaps(part, [&](std::uint32_t i, std::uint32_t j) {
          found.emplace_back(std::min(i, j), std::max(i, j));
        });
      EXPECT_EQ(sorted(found), found_by_comparison(a, a, [&](std::uint32_t i, std::uint32_t j) {
                  return i >= j || (group[i] != BoxTree::no_group && group[i] == group[j]);
                }));
    }
}

TEST(BoxTree, BoxesOfDoublesAreRoundedOutwardsToTheNextFloat) {
  constexpr double end = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<float>::max();
  std::vector<double> values = {0.0,     1.0,     0x1p-1074,       0x1p-150, 0x1p-149, 0x1.8p-149,
                                largest, 0x1p128, 0x1.fffffffp127, 0x1p1000, end,      0.1};
  std::mt19937_64 random(6);
  for (int i = 0; i < 10000; ++i)
    values.push_back(
        std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 250) - 180));
  for (const double size : values)
    for (const double value : {size, -size}) {
      const float down = round_down(value), up = round_up(value);
      EXPECT_LE(static_cast<double>(down), value);
      EXPECT_GE(static_cast<double>(up), value);
      if (value < end) {
        EXPECT_GT(
            static_cast<double>(std::nextafterf(down, std::numeric_limits<float>::infinity())),
            value);
      }
      EXPECT_EQ(up, -round_down(-value));
      if (static_cast<double>(static_cast<float>(value)) == value) {
        EXPECT_EQ(down, up);
      }
    }
}

}  // namespace
}  // namespace sectile
