// Which vertices of a rounded mesh are clear, against stars put together from all of its triangles.
#include "rounding/clear_stars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "rounding/clear_star.h"
#include "rounding/rounding_grid.h"
#include "sectile/primitives.h"
#include "sectile/sectile.h"
#include "sectile/transform.h"
#include "storage/block_triangles.h"

namespace sectile {
namespace {

struct Counts {
  std::size_t clear = 0, looked_at = 0, vertices = 0;
};

Counts check_stars(const Solid& solid, Rounding::Numbers numbers) {
  Rounding how;
  how.numbers = numbers;
  auto triangles = block_triangles(*solid.data());
  EXPECT_TRUE(triangles.has_value());
  if (!triangles) return {};
  const RoundedTriangles mesh(*solid.data(), std::move(*triangles), RoundingGrid(how));
  const double slack = mesh.farthest_move();
  const RoundedTriangles::Triangles unsettled = mesh.unsettled();
  const std::vector<std::uint8_t> clear = clear_stars(mesh, unsettled, slack);

  std::map<std::uint32_t, std::vector<StarTriangle>> stars;
  for (const std::uint32_t t : unsettled)
    for (const std::uint32_t v : mesh.corners(t)) stars[v];
  const std::vector<Vec3>& at = mesh.positions();
  for (std::uint32_t t = 0; t < mesh.size(); ++t) {
    const auto [a, b, c] = mesh.corners(t);
    const Facing facing(PlaneWithSlack(at[a], at[b], at[c], slack));
    for (const auto& [v, first, second] :
         {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}})
      if (const auto star = stars.find(v); star != stars.end())
        star->second.push_back({facing, at[first], at[second]});
  }
  Counts counts{0, stars.size(), at.size()};
  EXPECT_EQ(clear.size(), at.size());
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    const auto star = stars.find(v);
    const bool is_clear = star != stars.end() && is_clear_star(at[v], star->second);
    EXPECT_EQ(clear[v] != 0, is_clear) << "vertex " << v;
    counts.clear += clear[v];
  }
  return counts;
}

Solid ball(const Vec3& center, std::uint32_t rings) {
  return Solid::from_mesh(sphere_mesh(center, 1, 2 * rings, rings));
}

TEST(ClearStars, HaveAllTrianglesThatAreAtAVertex) {
  const Solid cut = boolean(ball({0, 0, 0}, 60), ball({0.3, 0.2, 0.1}, 60), Operation::subtract);
  const Counts beside_the_cut = check_stars(cut, Rounding::Numbers::doubles);
  EXPECT_GT(beside_the_cut.clear, 0.95 * double(beside_the_cut.looked_at));
  EXPECT_GT(beside_the_cut.looked_at, 500u);
  EXPECT_LT(beside_the_cut.looked_at, beside_the_cut.vertices / 2);

  const Counts all = check_stars(cut, Rounding::Numbers::floats);
  EXPECT_GT(all.clear, 0.95 * double(all.looked_at));
  EXPECT_GT(all.looked_at, 0.95 * double(all.vertices));
}

TEST(ClearStars, OfAResultThatIsTurnedAndCutAgain) {
  Solid solid = ball({0, 0, 0}, 20);
  for (int i = 1; i < 5; ++i) {
    const Transform turn = Transform::rotation_degrees({1.0, 2.0, 0.5 * i}, 31.0 * i);
    solid = boolean(transformed(solid, turn), ball({0.8, 0.3 * i, 0.2}, 15), Operation::subtract);
  }
  const Counts counts = check_stars(solid, Rounding::Numbers::doubles);
  EXPECT_GT(counts.clear, 0.9 * double(counts.looked_at));
}

}  // namespace
}  // namespace sectile
