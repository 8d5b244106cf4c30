#include "sectile/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

#include "primitives/circle.h"
#include "primitives/soup_builder.h"
#include "sectile/validate.h"

namespace sectile {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_legal(const Solid& solid) {
  for (const Violation& violation : validate(solid)) ADD_FAILURE() << violation.what;
}

void expect_counts(const Solid& solid, std::size_t vertices, std::size_t edges, std::size_t faces,
                   std::size_t loops, std::int64_t genus = 0, std::size_t shells = 1) {
  expect_legal(solid);
  const SolidCounts c = solid.counts();
  EXPECT_EQ(c.vertices, vertices);
  EXPECT_EQ(c.edges, edges);
  EXPECT_EQ(c.faces, faces);
  EXPECT_EQ(c.loops, loops);
  EXPECT_EQ(c.shells, shells);
  EXPECT_EQ(c.genus, genus);
}

/// The area of a regular polygon.
double polygon_area(double radius, double n) {
  return n / 2 * radius * radius * std::sin(2 * std::numbers::pi / n);
}

using Triangle = std::array<std::tuple<double, double, double>, 3>;

/// The triangles of a mesh as a set, each with its smallest corner first.
template <class Map>
std::set<Triangle> triangles(const PolygonMesh& mesh, bool turned, Map map) {
  std::set<Triangle> result;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = map(mesh.positions[mesh.indices[i + (turned ? 2 - k : k)]]);
      t[k] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

void expect_mirror_images(const PolygonMesh& mesh, bool diagonal) {
  const auto own = triangles(mesh, false, [](const Vec3& p) { return p; });
  EXPECT_TRUE(own == triangles(mesh, true, [](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; }));
  EXPECT_TRUE(own == triangles(mesh, true, [](const Vec3& p) { return Vec3{p.x, -p.y, p.z}; }));
  EXPECT_TRUE(own == triangles(mesh, true, [](const Vec3& p) { return Vec3{p.x, p.y, -p.z}; }));
  if (diagonal) {
    EXPECT_TRUE(own == triangles(mesh, true, [](const Vec3& p) { return Vec3{p.y, p.x, p.z}; }));
  }
}

TEST(Circle, RightAnglesAreExact) {
  const Vec2 expected[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (std::uint64_t n : {4u, 8u, 100u, 1024u, 4000000u})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Vec2 p = circle_point(k * n / 4, n);
      EXPECT_EQ(p.x, expected[k].x);
      EXPECT_EQ(p.y, expected[k].y);
    }
  for (int k = -9; k <= 9; ++k) {
    const Vec2 p = unit_vector(90.0 * k);
    EXPECT_EQ(p.x, expected[(k + 12) % 4].x);
    EXPECT_EQ(p.y, expected[(k + 12) % 4].y);
  }
}

TEST(Circle, HalvesAreExact) {
  EXPECT_EQ(circle_point(1, 12).y, 0.5);
  EXPECT_EQ(circle_point(1, 6).x, 0.5);
  EXPECT_EQ(circle_point(2, 6).x, -0.5);
  EXPECT_EQ(unit_vector(-30).y, -0.5);
  EXPECT_EQ(unit_vector(600).x, -0.5);
}

TEST(Circle, MirroredPointsAreMirrorImages) {
  for (std::uint64_t n : {3u, 5u, 6u, 7u, 10u, 12u, 20u, 64u, 100u}) {
    for (std::uint64_t k = 0; k < n; ++k) {
      const Vec2 p = circle_point(k, n), below = circle_point(n - k, n);
      EXPECT_EQ(p.x, below.x);
      EXPECT_EQ(p.y, -below.y);
      const Vec2 same = circle_point(3 * k, 3 * n);
      EXPECT_EQ(p.x, same.x);
      EXPECT_EQ(p.y, same.y);
      if (n % 2 == 0) {
        EXPECT_EQ(circle_point(k + n / 2, n).x, -p.x);
      }
      if (n % 4 == 0) {
        EXPECT_EQ(circle_point(k + n / 4, n).y, p.x);
      }
      const long double turn = static_cast<long double>(k) / static_cast<long double>(n);
      const long double angle = 2 * std::numbers::pi_v<long double> * turn;
      EXPECT_NEAR(p.x, static_cast<double>(std::cos(angle)), 2.5e-16);
      EXPECT_NEAR(p.y, static_cast<double>(std::sin(angle)), 2.5e-16);
    }
  }
}

TEST(Circle, NoNegativeZeros) {
  for (std::uint64_t k = 0; k < 8; ++k) {
    const Vec2 p = circle_point(k, 8), q = unit_vector(45.0 * static_cast<double>(k));
    for (const double value : {p.x, p.y, q.x, q.y}) EXPECT_FALSE(value == 0 && std::signbit(value));
  }
}

TEST(Coplanar, IsExact) {
  EXPECT_TRUE(coplanar({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}));
  EXPECT_FALSE(coplanar({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 1e-300}));
  EXPECT_FALSE(coplanar({0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}, {1, 1, std::nextafter(0.1, 1)}));
}

TEST(Block, IsABlock) {
  const Solid solid = block({1, 2, 3}, {2, 4, 7});
  expect_counts(solid, 8, 12, 6, 6);
  EXPECT_EQ(solid.volume(), 8);
  EXPECT_EQ(solid.area(), 28);
}

TEST(Wedge, IsHalfABlock) {
  const Solid solid = wedge({0, 0, 0}, {3, 2, 4});
  expect_counts(solid, 6, 9, 5, 5);
  EXPECT_EQ(solid.volume(), 12);
  EXPECT_EQ(solid.area(), 12 + 2 * (3 + 4 + 5));
}

TEST(Prism, HasPolygonsAndRectangles) {
  for (std::uint32_t n : {3u, 4u, 5u, 6u, 7u, 17u, 100u}) {
    const Solid solid = prism(2, 3, n);
    expect_counts(solid, 2 * n, 3 * n, n + 2, n + 2);
    EXPECT_NEAR(solid.volume(), 3 * polygon_area(2, n), 1e-12);
  }
  EXPECT_EQ(prism(1, 1, 4).volume(), 2);
}

TEST(Pyramid, HasOneApex) {
  for (std::uint32_t n : {3u, 4u, 5u, 64u}) {
    const Solid solid = pyramid(2, 3, n);
    expect_counts(solid, n + 1, 2 * n, n + 1, n + 1);
    EXPECT_NEAR(solid.volume(), polygon_area(2, n), 1e-12);
  }
}

TEST(Cylinder, IsAPrism) {
  EXPECT_TRUE(cylinder(1.5, 2, 12) == prism(1.5, 2, 12));
  expect_counts(cylinder(1, 1), 128, 192, 66, 66);
}

TEST(Cone, IsAPyramidOrAFrustum) {
  EXPECT_TRUE(cone(1, 0, 2, 7) == pyramid(1, 2, 7));
  expect_counts(cone(2, 1, 1, 4), 8, 12, 6, 6);
  const Solid solid = cone(2, 0.7, 3, 40);
  expect_legal(solid);
  EXPECT_EQ(solid.counts().vertices, 80u);
  EXPECT_EQ(solid.counts().genus, 0);
  const double expected = polygon_area(1, 40) * 3 * (4 + 1.4 + 0.49) / 3;
  EXPECT_NEAR(solid.volume(), expected, 1e-12);
  EXPECT_NEAR(cone(0.7, 2, 3, 40).volume(), expected, 1e-12);
}

TEST(Sphere, HasTrianglesOnly) {
  const Solid octahedron = sphere(1, 4, 2);
  expect_counts(octahedron, 6, 12, 8, 8);
  EXPECT_NEAR(octahedron.volume(), 4.0 / 3, 1e-15);
  for (const auto& [n, m] : {std::pair{3u, 2u}, {5u, 3u}, {8u, 7u}, {12u, 6u}, {64u, 32u}}) {
    const Solid solid = sphere(2, n, m);
    const std::size_t triangles = 2 * n * (m - 1);
    expect_legal(solid);
    const PolygonMesh mesh = solid.to_mesh();
    EXPECT_EQ(mesh.positions.size(), n * (m - 1) + 2);
    EXPECT_EQ(mesh.face_sizes, std::vector<std::uint32_t>(triangles, 3));
    // Some of them happen to be coplanar, and are one face of the solid.
    EXPECT_LE(solid.counts().faces, triangles);
  }
  const double volume = sphere(1, 200, 100).volume();
  EXPECT_NEAR(volume, 4 * std::numbers::pi / 3, 0.005);
  EXPECT_LT(volume, 4 * std::numbers::pi / 3);
}

// Quadrilaterals that a mirror maps to themselves are planar; then either diagonal will do.
TEST(Sphere, IsItsOwnMirrorImage) {
  expect_mirror_images(sphere_mesh({0, 0, 0}, 1.3, 16, 10), true);
  expect_mirror_images(sphere_mesh({0, 0, 0}, 0.7, 40, 2), true);
  expect_mirror_images(sphere_mesh({0, 0, 0}, 0.9, 24, 6), true);
}

TEST(Sphere, MeshAndSolidAgree) {
  const Solid solid = Solid::from_mesh(sphere_mesh({5, 6, 7}, 2, 16, 8));
  expect_legal(solid);
  EXPECT_NEAR(solid.volume(), sphere(2, 16, 8).volume(), 1e-12);
  EXPECT_TRUE(Solid::from_mesh(sphere_mesh({0, 0, 0}, 2, 16, 8)) == sphere(2, 16, 8));
}

TEST(Torus, HasGenusOne) {
  const Solid solid = torus(3, 1, 12, 8);
  expect_legal(solid);
  EXPECT_EQ(solid.counts().vertices, 96u);
  EXPECT_EQ(solid.counts().genus, 1);
  EXPECT_EQ(solid.counts().shells, 1u);
  // Pappus, with the regular polygon's correction of the way round.
  const double round = polygon_area(1, 12);
  EXPECT_NEAR(solid.volume(), 2 * 3 * polygon_area(1, 8) * round, 1e-12);
}

TEST(Torus, IsItsOwnMirrorImage) {
  const PolygonMesh mesh = torus(3, 1, 16, 8).to_mesh();
  // Planar faces may be cut by either diagonal on export, so only corners and volume are compared.
  std::set<std::tuple<double, double, double>> corners;
  for (const Vec3& p : mesh.positions) corners.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  for (const Vec3& p : mesh.positions) {
    EXPECT_TRUE(corners.contains({0 - p.x, p.y + 0.0, p.z + 0.0}));
    EXPECT_TRUE(corners.contains({p.y + 0.0, p.x + 0.0, p.z + 0.0}));
    EXPECT_TRUE(corners.contains({p.x + 0.0, p.y + 0.0, 0 - p.z}));
  }
}

TEST(Extrude, KeepsHoles) {
  Profile profile;
  profile.outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  profile.holes = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{5, 5}, {5, 8}, {8, 5}}};
  const Solid solid = extrude(profile, 2);
  expect_counts(solid, 22, 33, 13, 17, 2);
  EXPECT_EQ(solid.volume(), 2 * (100 - 1 - 4.5));
}

TEST(Extrude, MendsOrientationAndRepeats) {
  Profile profile;
  profile.outer = {{0, 0}, {0, 4}, {0, 4}, {4, 4}, {4, 0}, {0, 0}};
  profile.holes = {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  const Solid solid = extrude(profile, 1);
  expect_counts(solid, 16, 24, 10, 12, 1);
  EXPECT_EQ(solid.volume(), 15);
}

TEST(Revolve, OffTheAxisMakesARing) {
  const Solid solid = revolve({{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {}}, 4);
  expect_counts(solid, 16, 24, 10, 12, 1);
  EXPECT_EQ(solid.volume(), 6);
}

TEST(Revolve, OnTheAxisMakesAClosedSolid) {
  const Solid solid = revolve({{{0, 0}, {2, 0}, {0, 3}}, {}}, 9);
  EXPECT_TRUE(solid == pyramid(2, 3, 9));
  const Solid spindle = revolve({{{0, -2}, {1, 0}, {0, 2}}, {}}, 6);
  expect_counts(spindle, 8, 18, 12, 12);
}

TEST(Revolve, HolesMakeCavities) {
  const Profile profile{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}};
  const Solid solid = revolve(profile, 4);
  expect_legal(solid);
  EXPECT_EQ(solid.counts().shells, 2u);
  EXPECT_EQ(solid.counts().genus, 1);
  EXPECT_EQ(solid.volume(), 2 * 16 * 4 - 6);
}

TEST(Revolve, MayTouchTheAxisInOnePoint) {
  const Solid solid = revolve({{{0, 0}, {2, -1}, {2, 1}}, {}}, 8);
  expect_legal(solid);
  EXPECT_NEAR(solid.volume(), polygon_area(2, 8) * 2 * 2 / 3, 1e-12);
}

TEST(Arguments, AreChecked) {
  EXPECT_THROW(block({0, 0, 0}, {1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(block({0, 0, 0}, {1, infinity, 1}), std::invalid_argument);
  EXPECT_THROW(wedge({0, 0, 0}, {-1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(prism(1, 1, 2), std::invalid_argument);
  EXPECT_THROW(prism(0, 1, 3), std::invalid_argument);
  EXPECT_THROW(pyramid(1, -1, 3), std::invalid_argument);
  EXPECT_THROW(cylinder(std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(cone(0, 1, 1), std::invalid_argument);
  EXPECT_THROW(cone(1, -1, 1), std::invalid_argument);
  EXPECT_THROW(sphere(1, 2, 2), std::invalid_argument);
  EXPECT_THROW(sphere(1, 3, 1), std::invalid_argument);
  EXPECT_THROW(sphere_mesh({0, 0, 0}, 1, 4000000000u, 4000000000u), std::invalid_argument);
  EXPECT_THROW(torus(1, 1), std::invalid_argument);
  EXPECT_THROW(torus(1, 2), std::invalid_argument);
  EXPECT_THROW(torus(2, 1, 3000000000u, 8), std::invalid_argument);
  EXPECT_THROW(extrude({{{0, 0}, {1, 0}}, {}}, 1), std::invalid_argument);
  EXPECT_THROW(extrude({{{0, 0}, {1, 0}, {2, 0}}, {}}, 1), std::invalid_argument);
  EXPECT_THROW(extrude({{{0, 0}, {1, 0}, {infinity, 1}}, {}}, 1), std::invalid_argument);
  EXPECT_THROW(extrude({{{0, 0}, {1, 0}, {0, 1}}, {}}, 0), std::invalid_argument);
  EXPECT_THROW(revolve({{{-1, 0}, {1, 0}, {0, 1}}, {}}, 8), std::invalid_argument);
  try {
    cylinder(-2, 1);
    FAIL() << "a negative radius was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("radius"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sectile
