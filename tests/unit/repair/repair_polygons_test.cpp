// Prisms over polygons whatever their corners: these may lie on edges, edges may cross each other
// or run along each other. What is material of them follows from winding numbers in the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

struct Place {
  double x, y;
  friend bool operator==(const Place&, const Place&) = default;
};
using Polygon = std::vector<Place>;

PolygonMesh prism(const Polygon& base) {
  const auto n = static_cast<std::uint32_t>(base.size());
  PolygonMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const Place& p : base) mesh.positions.push_back({p.x, p.y, z});
  for (std::uint32_t i = n; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < n; ++i) mesh.indices.push_back(n + i);
  mesh.face_sizes = {n, n};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.indices.insert(mesh.indices.end(), {i, j, n + j, n + i});
    mesh.face_sizes.push_back(4);
  }
  return mesh;
}

// Where edges begin, end or cross.
std::vector<double> ends_of_slabs(const Polygon& polygon) {
  std::vector<double> ends;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    ends.push_back(a.x);
    for (std::size_t j = 0; j < i; ++j) {
      const Place &c = polygon[j], &d = polygon[(j + 1) % polygon.size()];
      const double det = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
      if (det == 0) continue;
      const double t = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / det;
      if (t >= 0 && t <= 1) ends.push_back(a.x + t * (b.x - a.x));
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

// Slab by slab: no edges cross within one.
template <class IsMaterial>
double area_where(const Polygon& polygon, const IsMaterial& is_material) {
  const std::vector<double> ends = ends_of_slabs(polygon);
  double area = 0;
  for (std::size_t s = 0; s + 1 < ends.size(); ++s) {
    const double width = ends[s + 1] - ends[s], x = 0.5 * (ends[s] + ends[s + 1]);
    if (width < 1e-9) continue;
    std::vector<std::pair<double, int>> edges;  // height in the middle, and way
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Place &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.x < x) == (b.x < x)) continue;
      edges.push_back({a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x), a.x < b.x ? 1 : -1});
    }
    std::sort(edges.begin(), edges.end());
    int winding = 0;
    for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
      winding += edges[e].second;
      if (is_material(winding)) area += width * (edges[e + 1].first - edges[e].first);
    }
  }
  return area;
}

double repaired_volume(const Polygon& base, Rule rule) {
  RepairOptions options;
  options.rule = rule;
  try {
    const Solid solid = repair(prism(base), options);
    EXPECT_TRUE(validate(solid).empty());
    return solid.volume();
  } catch (const Error& error) {
    ADD_FAILURE() << error.what();
    return -1;
  }
}

void expect_winding_numbers(const Polygon& base) {
  const double odd = area_where(base, [](int w) { return w % 2 != 0; }),
               nonzero = area_where(base, [](int w) { return w != 0; });
  EXPECT_NEAR(repaired_volume(base, Rule::odd), odd, 1e-9);
  EXPECT_NEAR(repaired_volume(base, Rule::nonzero), nonzero, 1e-9);
  // What hangs together and is inside out as a whole is turned around.
  const double positive = repaired_volume(base, Rule::positive);
  EXPECT_LE(positive, nonzero + 1e-9);
  EXPECT_GE(positive, std::min(area_where(base, [](int w) { return w >= 1; }),
                               area_where(base, [](int w) { return w <= -1; })) -
                          1e-9);
}

TEST(RepairPolygons, ALoopThatPassesItsOwnEdgeInACorner) {
  const Polygon bow = {{1, 3}, {1.5, 3}, {0, 0}, {2, 2}, {1, 2}};
  EXPECT_NEAR(repaired_volume(bow, Rule::odd), 1.25, 1e-12);
  EXPECT_NEAR(repaired_volume(bow, Rule::nonzero), 1.25, 1e-12);
  expect_winding_numbers(bow);
}

TEST(RepairPolygons, ALoopThatRunsAlongItsOwnEdgeAndPassesIt) {
  expect_winding_numbers({{0, 0}, {4, 0}, {4, 2}, {3, 0}, {1, 0}, {0, -2}});
  expect_winding_numbers({{0, 0}, {4, 0}, {4, 2}, {3, 0}, {1, 0}, {0, 2}});
}

// Calls visit(polygon) for polygons of some corners on a grid, until something fails.
template <class Visit>
void for_each_polygon(unsigned seed, int count, int most_corners, int grid, const Visit& visit) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    Polygon base;
    for (int corners = 3 + below(most_corners - 2); corners > 0; --corners) {
      const Place p{double(below(grid)), double(below(grid))};
      if (base.empty() || !(p == base.back())) base.push_back(p);
    }
    if (base.size() < 3 || base.front() == base.back()) continue;
    testing::Message what;
    for (const Place& p : base) what << " " << p.x << "," << p.y;
    SCOPED_TRACE(what);
    visit(base);
  }
}

TEST(RepairPolygons, OfRandomCornersOnAGrid) {
  for_each_polygon(11, cases(1500), 8, 4, expect_winding_numbers);
  for_each_polygon(12, cases(200), 24, 6, expect_winding_numbers);
}

// Faces that touch themselves are legal; cells() divides them where they do.
TEST(RepairPolygons, CellsOfThoseThatAreLegal) {
  const Solid across = block({0.5, 0.25, 0.5}, {2.5, 2.75, 1.5});
  int legal = 0;
  for_each_polygon(13, cases(20000), 8, 4, [&](const Polygon& base) {
    Solid solid;
    try {
      solid = Solid::from_mesh(prism(base));
    } catch (const InvalidSolid&) {
      return;
    }
    ++legal;
    EXPECT_NEAR(solid.volume(), area_where(base, [](int w) { return w == 1; }), 1e-9);
    EXPECT_EQ(area_where(base, [](int w) { return w != 0 && w != 1; }), 0);
    const Solid both[] = {solid, across};
    double volume[2] = {0, 0}, common = 0;
    for (const SolidCell& cell : cells(both)) {
      EXPECT_TRUE(validate(cell.solid).empty());
      for (const std::uint32_t operand : cell.operands) volume[operand] += cell.solid.volume();
      if (cell.operands.size() == 2) common = cell.solid.volume();
    }
    EXPECT_NEAR(volume[0], solid.volume(), 1e-9);
    EXPECT_NEAR(volume[1], across.volume(), 1e-9);
    EXPECT_NEAR(boolean(solid, across, Operation::intersect).volume(), common, 1e-9);
  });
  EXPECT_GT(legal, cases(500));
}

}  // namespace
}  // namespace sectile
