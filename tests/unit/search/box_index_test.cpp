#include "search/box_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sectile {
namespace {

std::vector<Box> random_boxes(std::size_t count, float size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 10), extent(0, size);
  std::vector<Box> boxes(count);
  for (Box& box : boxes)
    for (int k = 0; k < 3; ++k) {
      box.low[k] = place(random);
      box.high[k] = box.low[k] + extent(random);
    }
  return boxes;
}

TEST(BoxIndex, FindsAllThatOverlapAndNoOthers) {
  for (const std::size_t count : {1u, 3u, 4u, 5u, 16u, 17u, 1000u})
    for (const float size : {0.0f, 0.5f, 10.0f}) {
      const std::vector<Box> boxes = random_boxes(count, size, 3);
      const BoxIndex index(boxes);
      for (const Box& box : random_boxes(50, 3, 4)) {
        std::vector<std::uint32_t> expected, found;
        for (std::uint32_t i = 0; i < count; ++i)
          if (boxes[i].overlaps(box)) expected.push_back(i);
        EXPECT_TRUE(index.overlapping(box, [&](std::uint32_t i) {
          found.push_back(i);
          return true;
        }));
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
        EXPECT_EQ(index.any_overlaps(box), !expected.empty());
      }
    }
}

TEST(BoxIndex, FindsBoxesThatTouchAndInfiniteOnes) {
  const BoxIndex index({Box{{0, 0, 0}, {1, 1, 1}}, Box::everything()});
  int found = 0;
  index.overlapping(Box{{1, 1, 1}, {1, 1, 1}}, [&](std::uint32_t) { return ++found > 0; });
  EXPECT_EQ(found, 2);
}

TEST(BoxIndex, WhatIsEverywhereMeetsEachBoxOnce) {
  for (const std::size_t count : {1u, 5u, 21u, 66u}) {
    std::size_t found = 0;
    BoxIndex(random_boxes(count, 1, 9)).overlapping(Box::everything(), [&](std::uint32_t) {
      return ++found > 0;
    });
    EXPECT_EQ(found, count);
  }
}

TEST(BoxIndex, StopsWhenItIsTold) {
  const BoxIndex index(random_boxes(100, 10, 7));
  int visited = 0;
  EXPECT_FALSE(index.overlapping(Box::everything(), [&](std::uint32_t) { return ++visited < 5; }));
  EXPECT_EQ(visited, 5);
}

TEST(BoxIndex, FindsOnlyTheFirstItems) {
  const std::vector<Box> boxes = random_boxes(77, 4, 11);
  const BoxIndex index(boxes, true);
  for (std::uint32_t first = 0; first <= boxes.size(); ++first)
    for (const Box& box : random_boxes(10, 3, 12)) {
      std::vector<std::uint32_t> expected, found;
      for (std::uint32_t i = 0; i < first; ++i)
        if (boxes[i].overlaps(box)) expected.push_back(i);
      index.overlapping(box, first, [&](std::uint32_t i) {
        found.push_back(i);
        return true;
      });
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
}

TEST(BoxIndex, OfNothingFindsNothing) {
  EXPECT_FALSE(BoxIndex().any_overlaps(Box::everything()));
  EXPECT_FALSE(BoxIndex(std::vector<Box>()).any_overlaps(Box::everything()));
}

}  // namespace
}  // namespace sectile
