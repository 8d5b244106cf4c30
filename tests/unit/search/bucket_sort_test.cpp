#include "search/bucket_sort.h"

#include <gtest/gtest.h>

#include <random>

namespace sectile {
namespace {

struct Element {
  std::uint32_t bucket, rest;
  friend auto operator<=>(const Element&, const Element&) = default;
};

std::vector<std::uint32_t> sort(std::vector<Element>& elements, std::size_t buckets) {
  return bucket_sort(
      elements, buckets, [](const Element& e) { return e.bucket; },
      [](const Element& a, const Element& b) { return a.rest < b.rest; });
}

TEST(BucketSort, NothingHasEmptyBuckets) {
  std::vector<Element> none;
  EXPECT_EQ(sort(none, 3), (std::vector<std::uint32_t>{0, 0, 0, 0}));
  EXPECT_EQ(sort(none, 0), std::vector<std::uint32_t>{0});
}

TEST(BucketSort, BucketsComeOneAfterTheOtherAndAreSorted) {
  std::vector<Element> elements{{2, 1}, {0, 7}, {2, 0}, {0, 5}};
  EXPECT_EQ(sort(elements, 4), (std::vector<std::uint32_t>{0, 2, 2, 4, 4}));
  EXPECT_EQ(elements, (std::vector<Element>{{0, 5}, {0, 7}, {2, 0}, {2, 1}}));
}

// Also with so many buckets that they are sorted on all cores.
TEST(BucketSort, IsTheOrderThatComparingFinds) {
  std::mt19937 random(1);
  for (const std::uint32_t buckets : {1u, 10u, 5000u, 100000u}) {
    std::vector<Element> elements(20000);
    for (std::uint32_t i = 0; i < elements.size(); ++i)
      elements[i] = {static_cast<std::uint32_t>(random() % buckets), i * 7919u};
    std::vector<Element> expected = elements;
    std::sort(expected.begin(), expected.end());
    const std::vector<std::uint32_t> begin = sort(elements, buckets);
    EXPECT_EQ(elements, expected);
    ASSERT_EQ(begin.size(), buckets + 1);
    EXPECT_EQ(begin.back(), elements.size());
    for (std::uint32_t b = 0; b < buckets; ++b)
      for (std::uint32_t i = begin[b]; i < begin[b + 1]; ++i) ASSERT_EQ(elements[i].bucket, b);
  }
}

}  // namespace
}  // namespace sectile
