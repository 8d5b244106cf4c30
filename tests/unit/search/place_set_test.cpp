// Places by their coordinates.
#include "search/place_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace sectile {
namespace {

Vec3 lattice_point(std::mt19937& random) {
  const auto coordinate = [&] { return double(random() % 21) - 10; };
  return {coordinate(), coordinate(), coordinate()};
}

TEST(PlaceSet, HasWhatWasAddedAndNothingElse) {
  std::mt19937 random(1);
  std::vector<Vec3> added;
  PlaceSet set;
  EXPECT_FALSE(set.has({0, 0, 0}));
  for (int i = 0; i < 2000; ++i) {
    const Vec3 place = lattice_point(random), other = lattice_point(random);
    set.add(place);
    added.push_back(place);
    EXPECT_TRUE(set.has(place));
    EXPECT_EQ(set.has(other), std::ranges::find(added, other) != added.end());
  }
}

TEST(PlaceSet, BothZerosAreOnePlace) {
  PlaceSet set;
  set.add({0.0, -0.0, 1});
  EXPECT_TRUE(set.has({-0.0, 0.0, 1}));
  EXPECT_FALSE(set.has({0.0, 0.0, -1}));
}

// Mirror images, and corners of one coordinate or another: sums of hashes tell faces apart.
TEST(PlaceSet, SumsOfHashesOfSymmetricTrianglesDiffer) {
  std::vector<std::uint64_t> sums;
  const double numbers[] = {-0.75, -0.5, 0.5, 0.75};
  std::vector<Vec3> places;
  for (const double x : numbers)
    for (const double y : numbers)
      for (const double z : numbers) places.push_back({x, y, z});
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        sums.push_back(hash_of(places[i]) + hash_of(places[j]) + hash_of(places[k]));
  std::ranges::sort(sums);
  EXPECT_EQ(std::ranges::adjacent_find(sums), sums.end());
}

}  // namespace
}  // namespace sectile
