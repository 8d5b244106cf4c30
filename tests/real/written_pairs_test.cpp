// Placed pairs of real meshes, written: rounding_pairs does more of them.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "real/real_meshes.h"
#include "real/written_pairs.h"

namespace sectile::test {
namespace {

TEST(WrittenPairsExhaustive, AreLegalAndHardlyMoved) {
  const std::vector<std::string> files = real_meshes();
  if (files.empty()) GTEST_SKIP() << "there are no meshes in " << SECTILE_REAL_MESHES;
  WrittenPairs pairs(1);
  constexpr std::uintmax_t most = 1'000'000;  // bytes
  for (const std::string& file : files)
    if (std::filesystem::file_size(file) < most) pairs.add(file);
  EXPECT_GT(pairs.meshes(), 50u);
  pairs.run(40);
  std::printf("%s\n", pairs.summary().c_str());
  EXPECT_GT(pairs.written(), 150);
  EXPECT_EQ(pairs.illegal(), 0);
  EXPECT_EQ(pairs.other_shape(), 0);
  EXPECT_EQ(pairs.refused(), 0);
  EXPECT_LE(pairs.median(Rounding::Numbers::doubles), 1);
  EXPECT_LE(pairs.median(Rounding::Numbers::floats), 1);
}

}  // namespace
}  // namespace sectile::test
