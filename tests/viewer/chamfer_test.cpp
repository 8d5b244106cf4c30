// The piece that a chamfer cuts off.
#include "scene/chamfer.h"

#include <gtest/gtest.h>

#include "scene/primitive_kind.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

Solid piece_of(const ChamferCut& cut) {
  return transformed(solid_of(cut.prism), cut.placement.transform());
}

TEST(Chamfer, EveryEdgeOfABlockExactly) {
  const Solid whole = block({-20, -15, 0}, {20, 15, 5});
  const SnapTargets features(snap_features(whole));
  ASSERT_EQ(features.features().edges.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const ChamferEdge edge = chamfer_edge(features, i);
    const ChamferCut cut = chamfer_cut(edge, 1.5);
    EXPECT_TRUE(cut.is_exact) << i;
    const double length = glm::distance(to_glm(edge.from), to_glm(edge.to));
    const Solid rest = boolean(whole, piece_of(cut), Operation::subtract);
    EXPECT_EQ(rest.volume(), 6000 - 0.5 * 1.5 * 1.5 * length) << i;
    EXPECT_EQ(rest.counts().faces, 7u) << i;
    EXPECT_TRUE(boolean(whole, rest, Operation::intersect) == rest);
  }
}

TEST(Chamfer, OtherAnglesNearly) {
  const Solid hexagon = prism(4, 3, 6);
  const SnapTargets features(snap_features(hexagon));
  for (std::size_t i = 0; i < features.features().edges.size(); ++i) {
    const ChamferEdge edge = chamfer_edge(features, i);
    const ChamferCut cut = chamfer_cut(edge, 0.5);
    const double length = glm::distance(to_glm(edge.from), to_glm(edge.to));
    const bool upright = edge.from.z != edge.to.z;
    const double area = 0.5 * 0.5 * 0.5 * (upright ? std::sin(M_PI / 3) : 1);
    EXPECT_NEAR(boolean(hexagon, piece_of(cut), Operation::intersect).volume(), area * length, 1e-9)
        << i;
  }
}

TEST(Chamfer, EdgesThatGoInwardsAreRefused) {
  const Solid step =
      boolean(block({0, 0, 0}, {2, 2, 1}), block({0, 0, 1}, {1, 2, 2}), Operation::unite);
  const SnapTargets features(snap_features(step));
  std::size_t refused = 0;
  for (std::size_t i = 0; i < features.features().edges.size(); ++i) try {
      chamfer_edge(features, i);
    } catch (const std::invalid_argument& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("inwards"), std::string::npos);
      EXPECT_EQ(features.features().edges[i].from.x, 1);
      EXPECT_EQ(features.features().edges[i].from.z, 1);
    }
  EXPECT_EQ(refused, 1u);
}

TEST(Chamfer, NeedsAPositiveWidth) {
  const SnapTargets features(snap_features(block({0, 0, 0}, {1, 1, 1})));
  const ChamferEdge edge = chamfer_edge(features, 0);
  EXPECT_THROW(chamfer_cut(edge, 0), std::invalid_argument);
  EXPECT_THROW(chamfer_cut(edge, -1), std::invalid_argument);
}

}  // namespace
}  // namespace sectile::viewer
