// Corners on edges of others become corners of these, where rounding moves any of them.
#include "rounding/common_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "cases.h"
#include "rounding/crowded_edges.h"
#include "sectile/rounding.h"
#include "sectile/sectile.h"
#include "sectile/transform.h"
#include "selftest/solid_surface.h"
#include "storage/solid_data.h"
#include "unit/exact_mesh_checker.h"
#include "unit/manifold_check.h"

namespace sectile {
namespace {

using Numbers = std::array<std::int64_t, 3>;

Numbers numbers_at(const Geometry& geometry, PointId p) {
  const Vec3& at = geometry.position(p);
  return {std::int64_t(at.x), std::int64_t(at.y), std::int64_t(at.z)};
}
Numbers minus(const Numbers& a, const Numbers& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Numbers& a, const Numbers& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
bool is_within(const Numbers& p, const Numbers& from, const Numbers& to) {
  const Numbers way = minus(to, from), part = minus(p, from);
  return cross(way, part) == Numbers{} && dot(way, part) > 0 && dot(way, part) < dot(way, way);
}

void add(PolygonMesh& mesh, const std::array<Vec3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
    mesh.indices.push_back(first + k);
  mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
}

constexpr int most_walls = 60;

// Thin walls from one line, each in a direction and between ends of its own.
PolygonMesh walls(std::mt19937& random, int count) {
  PolygonMesh mesh;
  const auto below = [&](int n) { return static_cast<double>(random() % unsigned(n)); };
  std::vector<int> directions(most_walls);
  std::iota(directions.begin(), directions.end(), 0);
  std::shuffle(directions.begin(), directions.end(), random);
  for (int wall = 0; wall < count; ++wall) {
    const double low = below(400), high = low + 1 + below(400);
    const auto corner = [&](double angle) {
      return Vec3{std::round(640 * std::cos(angle)), std::round(640 * std::sin(angle)), below(800)};
    };
    const double angle = 0.1 * directions[std::size_t(wall)];
    add(mesh, {Vec3{0, 0, low}, Vec3{0, 0, high}, corner(angle), corner(angle + 0.07)});
  }
  return mesh;
}

// Spikes that have their tips on an edge of a tetrahedron.
PolygonMesh tips_on_an_edge(int count) {
  PolygonMesh mesh;
  add(mesh, {Vec3{0, 0, 0}, Vec3{10.0 * count, 0, 0}, Vec3{0, 60, 0}, Vec3{0, 0, 60}});
  for (int i = 0; i < count; ++i) {
    const double x = 10 * i + 5;
    add(mesh, {Vec3{x, 0, 0}, Vec3{x, -30, -200}, Vec3{x + 3, -33, -200}, Vec3{x - 3, -33, -201}});
  }
  return mesh;
}

struct Divided {
  TriangleSurface before, after;
  const Geometry* geometry;
};

Divided divide(const Solid& solid, const std::function<bool(PointId)>& moves) {
  const SolidData& data = *solid.data();
  const Kernel kernel(data.geometry());
  std::vector<FaceId> crossing;
  Divided divided{surface_of(data.brep(), kernel, crossing), {}, &data.geometry()};
  divided.after = divided.before;
  divide_on_common_lines(divided.after, kernel, moves);
  return divided;
}

void expect_mates_fit(const TriangleSurface& surface) {
  for (std::uint32_t t = 0; t < surface.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t s = surface.mate[t][k];
      ASSERT_LT(s, surface.size());
      const PointId from = surface.corners[t][k], to = surface.corners[t][(k + 1) % 3];
      bool found = false;
      for (std::size_t j = 0; j < 3; ++j)
        found |= surface.mate[s][j] == t && surface.corners[s][j] == to &&
                 surface.corners[s][(j + 1) % 3] == from;
      EXPECT_TRUE(found) << "triangle " << t << ", edge " << k;
    }
}

// Per face: the sum of the normals of its triangles, each of which looks the same way.
std::map<std::uint32_t, Numbers> areas(const TriangleSurface& surface, const Geometry& geometry) {
  std::map<std::uint32_t, Numbers> areas;
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    const auto& [a, b, c] = surface.corners[t];
    const Numbers p = numbers_at(geometry, a), q = numbers_at(geometry, b),
                  r = numbers_at(geometry, c), normal = cross(minus(q, p), minus(r, p));
    EXPECT_NE(normal, Numbers{}) << "triangle " << t << " has no area";
    Numbers& sum = areas[surface.face[t]];
    EXPECT_GE(dot(sum, normal), 0);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += normal[k];
  }
  return areas;
}

// Edges with a corner within, of those that rounding may tear apart.
std::size_t edges_to_divide(const TriangleSurface& surface, const Geometry& geometry,
                            const std::function<bool(PointId)>& moves) {
  std::size_t count = 0;
  for (const auto& corners : surface.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId from = corners[k], to = corners[(k + 1) % 3];
      bool is_to_divide = false;
      for (const auto& others : surface.corners)
        for (const PointId p : others)
          is_to_divide |= (moves(from) || moves(to) || moves(p)) &&
                          is_within(numbers_at(geometry, p), numbers_at(geometry, from),
                                    numbers_at(geometry, to));
      count += is_to_divide ? 1 : 0;
    }
  return count;
}

void expect_divided(const Solid& solid, const std::function<bool(PointId)>& moves) {
  const auto [before, after, geometry] = divide(solid, moves);
  expect_mates_fit(after);
  EXPECT_EQ(areas(before, *geometry), areas(after, *geometry));
  EXPECT_GT(edges_to_divide(before, *geometry, moves), 0u);
  EXPECT_EQ(edges_to_divide(after, *geometry, moves), 0u);
}

bool always(PointId) {
  return true;
}
bool never(PointId) {
  return false;
}
bool every_third(PointId p) {
  return p.value() % 3 == 0;
}

TEST(CommonLines, WallsFromOneLineHaveEachOthersEnds) {
  for (int seed = 0; seed < cases(20); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Solid book = Solid::from_mesh(walls(random, 3 + seed));
    expect_divided(book, always);
    expect_divided(book, every_third);
  }
}

TEST(CommonLines, AnEdgeHasTheTipsThatLieOnIt) {
  const Solid solid = Solid::from_mesh(tips_on_an_edge(12));
  expect_divided(solid, always);
  expect_divided(solid, every_third);
  EXPECT_EQ(divide(solid, always).after.size(), divide(solid, always).before.size() + 2 * 12);
}

TEST(CommonLines, NothingIsDividedWhereNothingMoves) {
  std::mt19937 random(1);
  const Divided divided = divide(Solid::from_mesh(walls(random, 30)), never);
  EXPECT_EQ(divided.before.corners, divided.after.corners);
}

std::vector<PlacedTriangle> placed(const PolygonMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> number;
  std::vector<PlacedTriangle> triangles(mesh.face_sizes.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const Vec3& at = mesh.positions[mesh.indices[i]];
    const auto next = static_cast<std::uint32_t>(number.size());
    triangles[i / 3].at[i % 3] = at;
    triangles[i / 3].vertex[i % 3] = number.try_emplace({at.x, at.y, at.z}, next).first->second;
  }
  return triangles;
}

TEST(CommonLines, AreCrowdedWhereCornersLieOnManyEdgesEach) {
  std::mt19937 random(1);
  EXPECT_TRUE(have_crowded_edges(placed(walls(random, 20)), 0x1p-40));
  EXPECT_FALSE(have_crowded_edges(placed(walls(random, 2)), 0x1p-40));
  EXPECT_FALSE(have_crowded_edges(placed(tips_on_an_edge(12)), 0x1p-40));
  PolygonMesh beside = walls(random, 20);  // corners near edges, and certainly not on them
  for (std::size_t i = 0; i < beside.positions.size(); ++i)
    if (beside.positions[i].x == 0) beside.positions[i].y += 0x1p-20 * double(i);
  EXPECT_FALSE(have_crowded_edges(placed(beside), 0x1p-40));
}

// As they are written, wherever they are: each corner at its nearest place.
void expect_nothing_displaced(const Solid& solid, Rounding::Numbers numbers) {
  const Solid turned = transformed(solid, Transform::rotation_degrees({1, 2, 3}, 40));
  Rounding how;
  how.numbers = numbers;
  const RoundedMesh written = rounded_mesh(turned, how);
  EXPECT_EQ(test::ExactMeshChecker(written.mesh).verdict(), "");
  EXPECT_EQ(written.report.displaced, 0u);
  EXPECT_EQ(written.report.merged + written.report.flipped + written.report.resolved, 0u);
  how.separate_touching = true;
  const RoundedMesh apart = rounded_mesh(turned, how);
  EXPECT_EQ(test::ExactMeshChecker(apart.mesh).verdict(), "");
  EXPECT_EQ(test::manifold_fault(apart.mesh), "");
  EXPECT_EQ(apart.report.displaced, apart.report.separated);
}

TEST(CommonLines, ATurnedBookIsWrittenWithItsCornersAtTheirNearestPlaces) {
  for (int seed = 0; seed < cases(3); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Solid book = Solid::from_mesh(walls(random, 4 + 2 * seed));
    for (const auto numbers : {Rounding::Numbers::doubles, Rounding::Numbers::floats})
      expect_nothing_displaced(book, numbers);
  }
}

TEST(CommonLines, TipsOnATurnedEdgeAreWrittenAtTheirNearestPlaces) {
  for (const auto numbers : {Rounding::Numbers::doubles, Rounding::Numbers::floats})
    expect_nothing_displaced(Solid::from_mesh(tips_on_an_edge(12)), numbers);
}

}  // namespace
}  // namespace sectile
