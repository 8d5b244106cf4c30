// Edges on one line are found together, whatever their ends are.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <vector>

#include "search/edges_by_line.h"

namespace sectile {
namespace {

struct Edges {
  Geometry geometry;
  std::vector<PointId> points;
  std::vector<PointPair> edges;

  std::uint32_t add(const Vec3& p) {
    points.push_back(geometry.add_point(p));
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  void add(const Vec3& p, const Vec3& q) {
    const std::uint32_t from = add(p);
    edges.push_back({from, add(q)});
  }
};

// By the definition, in whole numbers.
bool are_on_one_line(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
}

TEST(EdgesByLine, AreThoseOfEachLineOnAGrid) {
  std::mt19937 random(1);
  for (const int size : {2, 3, 5, 1000}) {
    for (const double shift : {0.0, 1e6}) {
      const auto below = [&](int n) {
        return static_cast<double>(random() % static_cast<unsigned>(n));
      };
      const auto place = [&] { return Vec3{below(size) + shift, below(size), below(size)}; };
      Edges all;
      while (all.edges.size() < 300) {
        const Vec3 p = place(), q = place();
        if (!(p == q)) all.add(p, q);
      }
      std::multiset<std::size_t> expected, found;
      std::vector<std::uint8_t> known(all.edges.size(), 0);
      const auto at = [&](std::uint32_t p) { return all.geometry.position(all.points[p]); };
      for (std::size_t i = 0; i < all.edges.size(); ++i) {
        if (known[i] != 0) continue;
        std::size_t count = 0;
        for (std::size_t j = i; j < all.edges.size(); ++j) {
          const auto [from, to] = all.edges[i];
          if (!are_on_one_line(at(from), at(to), at(all.edges[j].from)) ||
              !are_on_one_line(at(from), at(to), at(all.edges[j].to)))
            continue;
          known[j] = 1;
          ++count;
        }
        expected.insert(count);
      }
      const Kernel kernel(all.geometry);
      for (const EdgesOfLine& line : edges_by_line(kernel, all.points, all.edges)) {
        found.insert(line.edges.size());
        for (const auto& [p, q] : line.edges)
          for (const std::uint32_t end : {p, q})
            EXPECT_TRUE(are_on_one_line(at(line.extent.from), at(line.extent.to), at(end)));
      }
      EXPECT_EQ(found, expected) << size << ' ' << shift;
    }
  }
}

TEST(EdgesByLine, ALineIsCrowdedWhereEdgesRunBesideEachOther) {
  Edges chain, staggered;
  for (int i = 0; i < 100; ++i) {
    chain.add({1.0 * i, 0, 0}, {i + 1.0, 0, 0});
    staggered.add({1.0 * i, 2.0 * i, 0}, {i + 100.0, 2.0 * i + 200, 0});
  }
  EXPECT_TRUE(crowded_lines(Kernel(chain.geometry), chain.points, chain.edges, 1).empty());
  const auto lines =
      crowded_lines(Kernel(staggered.geometry), staggered.points, staggered.edges, 99);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(staggered.geometry.position(staggered.points[lines[0].from]), (Vec3{0, 0, 0}));
  EXPECT_EQ(staggered.geometry.position(staggered.points[lines[0].to]), (Vec3{199, 398, 0}));
  EXPECT_TRUE(
      crowded_lines(Kernel(staggered.geometry), staggered.points, staggered.edges, 100).empty());
}

}  // namespace
}  // namespace sectile
