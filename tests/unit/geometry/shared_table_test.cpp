#include "geometry/shared_table.h"

#include <gtest/gtest.h>

namespace sectile {
namespace {

// More than are looked at one by one.
class ManyNumbers : public testing::Test {
 protected:
  ManyNumbers() {
    for (int i = 0; i < 100; ++i) numbers.push_back(std::make_shared<const int>(7));
  }
  std::vector<std::shared_ptr<const int>> numbers;
  SharedTable<int> table;
};

TEST_F(ManyNumbers, HavePlacesInTheOrderInWhichTheyCame) {
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(table.place(numbers[i]), i);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(table[static_cast<std::uint32_t>(i)], numbers[i]);
}

TEST_F(ManyNumbers, AreInTheTableOnce) {
  for (const auto& number : numbers) {
    table.place(number);
    table.place(numbers.front());
    table.place(number);
  }
  EXPECT_EQ(table.size(), numbers.size());
  for (std::size_t i = numbers.size(); i-- > 0;) EXPECT_EQ(table.place(numbers[i]), i);
  EXPECT_EQ(table.size(), numbers.size());
}

TEST_F(ManyNumbers, OfACopyAreTheCopysOwn) {
  for (const auto& number : numbers) table.place(number);
  SharedTable<int> copy = table;
  EXPECT_EQ(copy.place(std::make_shared<const int>(7)), numbers.size());
  EXPECT_EQ(table.size(), numbers.size());
  EXPECT_EQ(table.place(numbers[50]), 50);
}

}  // namespace
}  // namespace sectile
