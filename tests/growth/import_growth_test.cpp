// Imports of meshes whose boxes say little: large plane faces cut into slivers with many things
// standing on them, and long slanted things side by side.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "growth/steps.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"
#include "unit/walls_through_a_point.h"

namespace sectile {
namespace {

double growth_of_import(PolygonMesh (*make)(std::size_t), std::size_t n) {
  return growth([&](std::size_t size) { return [mesh = make(size)] { Solid::from_mesh(mesh); }; },
                n);
}

// Without the test for crossings: how the shells lie in each other is found out all the same.
double growth_of_nesting(PolygonMesh (*make)(std::size_t), std::size_t n) {
  ImportOptions trusted;
  trusted.trusted = true;
  return growth(
      [&](std::size_t size) { return [=, mesh = make(size)] { Solid::from_mesh(mesh, trusted); }; },
      n);
}

std::uint32_t add_vertex(PolygonMesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_face(PolygonMesh& mesh, std::initializer_list<std::uint32_t> corners) {
  mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  mesh.indices.insert(mesh.indices.end(), corners);
}

Solid plate_with_holes(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n)));
  const double width = 2 * side + 1;
  Profile profile;
  profile.outer = {{0, 0}, {width, 0}, {width, width}, {0, width}};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = 2 * i + 1, y = 2 * j + 1;
      profile.holes.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    }
  return extrude(profile, 1);
}

PolygonMesh triangles_of_a_plate(std::size_t n) {
  return plate_with_holes(n).to_mesh();
}

PolygonMesh prism_on(const std::vector<Vec2>& outline, double height) {
  PolygonMesh mesh;
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.0, height})
    for (const Vec2& p : outline) add_vertex(mesh, {p.x, p.y, z});
  mesh.face_sizes = {count, count};
  for (std::uint32_t i = count; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < count; ++i) mesh.indices.push_back(count + i);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t k = (i + 1) % count;
    add_face(mesh, {i, k, count + k, count + i});
  }
  return mesh;
}

PolygonMesh comb(std::size_t teeth) {
  const double width = static_cast<double>(teeth);
  std::vector<Vec2> outline{{0, -1}, {width, -1}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = static_cast<double>(i);
    outline.push_back({x + 0.5, width});
    outline.push_back({x, 0});
  }
  return prism_on(outline, 1);
}

PolygonMesh corrugated_block(std::size_t folds) {
  const double width = static_cast<double>(folds);
  std::vector<Vec2> outline{{0, -2}, {width, -2}};
  for (std::size_t i = folds + 1; i-- > 0;)
    outline.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : 1.0});
  return prism_on(outline, width);
}

void add_slanted_prism(PolygonMesh& mesh, const Vec3& at, double length) {
  std::array<std::uint32_t, 6> p;
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double u = at.x + (k % 3 == 1 ? 0.5 : 0), v = at.y + (k % 3 == 2 ? 0.5 : 0);
    p[k] = k < 3 ? add_vertex(mesh, {u, v, at.z})
                 : add_vertex(mesh, {u + length, v + 0.75 * length, at.z + length});
  }
  add_face(mesh, {p[2], p[1], p[0]});
  add_face(mesh, {p[3], p[4], p[5]});
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t next = (k + 1) % 3;
    add_face(mesh, {p[k], p[next], p[3 + next], p[3 + k]});
  }
}

// Prisms in a square grid, as long as the grid is wide.
PolygonMesh slanted_bundle(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  PolygonMesh mesh;
  for (std::size_t i = 0; i < side * side; ++i)
    add_slanted_prism(mesh, {static_cast<double>(i % side), static_cast<double>(i / side), 0},
                      static_cast<double>(side));
  return mesh;
}

// Beside each other: the boxes of long ones hold those of short ones.
PolygonMesh slanted_prisms_of_all_lengths(std::size_t n) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i), half = static_cast<double>(n * (i % 7 + 1)) / 16;
    add_slanted_prism(mesh, {x - half, -0.75 * half, -half}, 2 * half);
  }
  return mesh;
}

PolygonMesh walls_through_a_point(std::size_t n) {
  test::WallsThroughAPoint walls;
  walls.count = static_cast<int>(n);
  return walls.mesh();
}

TEST(Growth, ImportOfWallsThroughOnePoint) {
  EXPECT_LT(growth_of_import(walls_through_a_point, 200), n_log_n);
}

// Spikes from two corners, each past the other one, in all directions that fit.
PolygonMesh fans_into_each_other(std::size_t spikes) {
  PolygonMesh mesh;
  const std::uint32_t hubs[] = {add_vertex(mesh, {0, 0, 0}), add_vertex(mesh, {0.1, 0.2, 1})};
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random() % 1000000) / 1e6 - 0.5; };
  for (std::size_t i = 0; i < spikes; ++i) {
    const std::uint32_t hub = hubs[i % 2];
    const Vec3 end = mesh.positions[hubs[1 - i % 2]];
    const double x = end.x + number(), y = end.y + number(), size = 1e-9;
    const std::uint32_t a = add_vertex(mesh, {x + size, y, end.z}),
                        b = add_vertex(mesh, {x, y + size, end.z}),
                        c = add_vertex(mesh, {x - size, y - size, end.z});
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
      i % 2 == 0 ? add_face(mesh, {hub, q, p}) : add_face(mesh, {hub, p, q});
    i % 2 == 0 ? add_face(mesh, {a, b, c}) : add_face(mesh, {a, c, b});
  }
  return mesh;
}

// A thin prism from p to q.
void add_rod(PolygonMesh& mesh, const Vec3& p, const Vec3& q, double width) {
  std::array<std::uint32_t, 6> corner;
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3;
    const Vec3& at = k < 3 ? p : q;
    corner[k] =
        add_vertex(mesh, {at.x + width * std::cos(angle), at.y + width * std::sin(angle), at.z});
  }
  add_face(mesh, {corner[2], corner[1], corner[0]});
  add_face(mesh, {corner[3], corner[4], corner[5]});
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t next = (k + 1) % 3;
    add_face(mesh, {corner[k], corner[next], corner[3 + next], corner[3 + k]});
  }
}

// Layers of slanted rods, which lie across those of the layer below.
PolygonMesh woven_rods(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n)));
  PolygonMesh mesh;
  for (int layer = 0; layer < side; ++layer)
    for (int i = 0; i < side; ++i) {
      const double sign = layer % 2 == 0 ? 1 : -1, x = 2 * i * sign, z = 0.5 * layer;
      add_rod(mesh, {x, -2.0 * i, z}, {x + sign * side, side - 2.0 * i, z + side}, 0.1);
    }
  return mesh;
}

// Through a small part of space.
PolygonMesh rods_of_all_directions(std::size_t n) {
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random() % 1000000) / 1e6 - 0.5; };
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 middle{number(), number(), number()};
    const double x = 6 * number(), y = 6 * number(), z = 1 + number();
    add_rod(mesh, {middle.x - x, middle.y - y, middle.z - z},
            {middle.x + x, middle.y + y, middle.z + z}, 1e-7);
  }
  return mesh;
}

// Rods around an axis, twisted to one side, around others that are twisted to the other side.
PolygonMesh twisted_rods(std::size_t n) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = i % 2 == 0 ? 1 : 1.1, twist = i % 2 == 0 ? 1 : -1.2;
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    add_rod(mesh, {radius * std::cos(angle), radius * std::sin(angle), -2},
            {radius * std::cos(angle + twist), radius * std::sin(angle + twist), 2},
            0.5 / static_cast<double>(n));
  }
  return mesh;
}

// A cone on rings of long, thin triangles, on one face.
PolygonMesh cone_on_bands(std::size_t sides) {
  constexpr std::uint32_t rings = 4;
  const auto n = static_cast<std::uint32_t>(sides);
  PolygonMesh mesh;
  for (std::uint32_t r = 0; r <= rings; ++r)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, radius = 1 - 0.1 * r;
      add_vertex(mesh, {radius * std::cos(angle), radius * std::sin(angle), 0.2 * r});
    }
  const std::uint32_t apex = add_vertex(mesh, {0, 0, 2});
  mesh.face_sizes.push_back(n);
  for (std::uint32_t i = n; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    for (std::uint32_t r = 0; r < rings; ++r) {
      const std::uint32_t a = r * n + i, b = r * n + k;
      add_face(mesh, {a, b, b + n});
      add_face(mesh, {a, b + n, a + n});
    }
    add_face(mesh, {rings * n + i, rings * n + k, apex});
  }
  return mesh;
}

// Balls and cavities in turn, one close to the other: the triangles of one are in the boxes of
// those of very many.
PolygonMesh nested_balls(std::size_t n) {
  const PolygonMesh ball = sphere(1, 6, 4).to_mesh();
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = 1 + static_cast<double>(i) / static_cast<double>(n);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : ball.positions)
      add_vertex(mesh, {radius * p.x, radius * p.y, radius * p.z});
    mesh.face_sizes.insert(mesh.face_sizes.end(), ball.face_sizes.begin(), ball.face_sizes.end());
    for (std::size_t c = 0; c < ball.indices.size(); ++c) {
      const bool turned = (n - i) % 2 == 0;
      mesh.indices.push_back(first + ball.indices[turned ? c - c % 3 + 2 - c % 3 : c]);
    }
  }
  return mesh;
}

// Walls around a slanted line, each a little away from it in its own direction; `nearest` where the
// line begins.
PolygonMesh walls_beside_a_line(std::size_t n, double begin, double nearest) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double step = 2 * std::numbers::pi / static_cast<double>(n),
                 low = step * static_cast<double>(i), high = low + 0.5 * step;
    std::array<std::uint32_t, 6> p;
    for (std::uint32_t k = 0; k < 6; ++k) {
      const double t = k < 3 ? begin : 2,
                   r = k == 0   ? nearest
                       : k == 3 ? 1e-5
                                : 1,
                   by = k % 3 == 0   ? 0.5 * (low + high)
                        : k % 3 == 1 ? low
                                     : high;
      p[k] = add_vertex(mesh, {0.3 * t + r * std::cos(by), 0.5 * t + r * std::sin(by), t});
    }
    add_face(mesh, {p[0], p[2], p[1]});
    add_face(mesh, {p[3], p[4], p[5]});
    for (const auto& [j, k] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
      add_face(mesh, {p[j], p[k], p[k + 3]});
      add_face(mesh, {p[j], p[k + 3], p[j + 3]});
    }
  }
  return mesh;
}

TEST(ImportGrowth, WallsBesideALine) {
  const auto walls = [](std::size_t n) { return walls_beside_a_line(n, 1, 1e-5); };
  EXPECT_LT(growth_of_import(walls, 500), n_log_n);
}

// Around the origin numbers lie as close as one likes.
TEST(ImportGrowth, WallsBesideALineFromTheOrigin) {
  const auto walls = [](std::size_t n) { return walls_beside_a_line(n, 0, 1e-14); };
  EXPECT_LT(growth_of_import(walls, 500), n_log_n);
}

TEST(ImportGrowth, PlateWithHoles) {
  EXPECT_LT(growth([](std::size_t n) { return [n] { plate_with_holes(n); }; }, 400), n_log_n);
}

TEST(ImportGrowth, TrianglesOfAPlateWithHoles) {
  EXPECT_LT(growth_of_import(triangles_of_a_plate, 400), n_log_n);
}

TEST(ImportGrowth, Comb) {
  EXPECT_LT(growth_of_import(comb, 500), n_log_n);
}

TEST(ImportGrowth, CorrugatedBlock) {
  EXPECT_LT(growth_of_import(corrugated_block, 500), n_log_n);
}

TEST(ImportGrowth, SlantedBundle) {
  EXPECT_LT(growth_of_import(slanted_bundle, 400), n_log_n);
}

TEST(ImportGrowth, SlantedPrismsOfAllLengths) {
  EXPECT_LT(growth_of_import(slanted_prisms_of_all_lengths, 800), n_log_n);
}

TEST(ImportGrowth, FansThatReachIntoEachOther) {
  EXPECT_LT(growth_of_import(fans_into_each_other, 500), n_log_n);
}

TEST(ImportGrowth, NestingOfFansThatReachIntoEachOther) {
  EXPECT_LT(growth_of_nesting(fans_into_each_other, 1000), n_log_n);
}

TEST(ImportGrowth, NestingOfRodsOfAllDirections) {
  EXPECT_LT(growth_of_nesting(rods_of_all_directions, 1000), n_log_n);
}

TEST(ImportGrowth, NestedBalls) {
  EXPECT_LT(growth_of_import(nested_balls, 200), n_log_n);
}

TEST(ImportGrowth, NestingOfNestedBalls) {
  EXPECT_LT(growth_of_nesting(nested_balls, 100), n_log_n);
}

TEST(ImportGrowth, WovenRods) {
  EXPECT_LT(growth_of_import(woven_rods, 400), n_log_n);
}

TEST(ImportGrowth, TwistedRods) {
  EXPECT_LT(growth_of_import(twisted_rods, 500), n_log_n);
}

TEST(ImportGrowth, ConeOnBands) {
  EXPECT_LT(growth_of_import(cone_on_bands, 1000), n_log_n);
}

}  // namespace
}  // namespace sectile
