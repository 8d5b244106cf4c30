// Equal elements are found whatever their number, and whatever their hashes are worth.
#include "search/equal_elements.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace sectile {
namespace {

std::uint32_t mixed(std::uint32_t value) {
  return static_cast<std::uint32_t>((value + 1) * 0x9E3779B97F4A7C15u >> 32);
}

// Per element, the one that it is said to be equal to; itself if it is said to be the first.
template <class HashOf>
std::vector<std::uint32_t> firsts_found(const std::vector<std::uint32_t>& values,
                                        const HashOf& hash_of) {
  std::vector<std::uint32_t> first(values.size()), last(values.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) first[i] = last[i] = i;
  for_each_equal(
      values.size(), [&](std::uint32_t i) { return hash_of(values[i]); },
      [&](std::uint32_t i, std::uint32_t j) { return values[i] == values[j]; },
      [&](std::uint32_t earlier, std::uint32_t i) {
        EXPECT_EQ(first[i], i) << "told twice";
        EXPECT_LT(last[earlier], i) << "not in ascending order";
        first[i] = earlier;
        last[earlier] = i;
      });
  return first;
}

std::vector<std::uint32_t> firsts_of(const std::vector<std::uint32_t>& values) {
  std::map<std::uint32_t, std::uint32_t> seen;
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < values.size(); ++i)
    first.push_back(seen.try_emplace(values[i], i).first->second);
  return first;
}

TEST(EqualElements, AreToldWithTheFirstOfThem) {
  std::mt19937 random(3);
  for (const std::uint32_t count : {0u, 1u, 2u, 100u, 2047u, 2048u, 40000u, 200000u})
    for (const std::uint32_t kinds : {1u, 7u, count / 2 + 1, ~0u}) {
      std::vector<std::uint32_t> values(count);
      for (std::uint32_t& v : values) v = static_cast<std::uint32_t>(random()) % kinds;
      EXPECT_EQ(firsts_found(values, mixed), firsts_of(values)) << count << ' ' << kinds;
    }
}

TEST(EqualElements, AreToldFromOthersOfTheSameHash) {
  std::vector<std::uint32_t> values(5000);
  for (std::uint32_t i = 0; i < values.size(); ++i) values[i] = i % 600;
  const auto poor = [](std::uint32_t value) { return value % 3; };
  EXPECT_EQ(firsts_found(values, poor), firsts_of(values));
}

}  // namespace
}  // namespace sectile
