#include "search/edge_chains.h"

#include <gtest/gtest.h>

namespace sectile {
namespace {

using Chains = std::vector<std::vector<std::uint32_t>>;

Chains chains(const std::vector<PointPair>& edges) {
  return edge_chains(edges);
}

TEST(EdgeChains, APathIsOneChain) {
  EXPECT_EQ(chains({{1, 4}, {2, 7}, {2, 4}}), (Chains{{1, 4, 2, 7}}));
}
TEST(EdgeChains, ChainsEndWhereThreeEdgesMeet) {
  EXPECT_EQ(chains({{1, 2}, {2, 3}, {3, 4}, {3, 5}, {5, 6}}),
            (Chains{{1, 2, 3}, {3, 4}, {3, 5, 6}}));
}
TEST(EdgeChains, RingsAreNone) {
  EXPECT_EQ(chains({{1, 2}, {2, 3}, {1, 3}, {8, 9}}), (Chains{{8, 9}}));
}
TEST(EdgeChains, ARingThatHangsOnAChainEndsWhereItBegins) {
  EXPECT_EQ(chains({{1, 2}, {2, 3}, {3, 4}, {2, 4}}), (Chains{{1, 2}, {2, 3, 4, 2}}));
}
TEST(EdgeChains, NoEdgesAreNoChain) {
  EXPECT_EQ(chains({}), Chains());
}

}  // namespace
}  // namespace sectile
