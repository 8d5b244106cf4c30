// Booleans of solids that come near each other in many places, or only in boxes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "append_mesh.h"
#include "growth/steps.h"
#include "needles.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

struct Pair {
  Solid a, b;
};

auto unite(const Pair& pair) {
  return [pair] { boolean(pair.a, pair.b, Operation::unite); };
}

std::uint32_t root(std::size_t n) {
  return static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n))));
}

Solid plate(std::uint32_t columns, double low, double high) {
  return block({0, 0, low}, {2.0 * columns, 2.0 * columns, high});
}

// As a mesh: n separate pegs, or other things, in a square grid.
PolygonMesh in_grid(const PolygonMesh& one, std::uint32_t columns) {
  PolygonMesh all;
  for (std::uint32_t i = 0; i < columns * columns; ++i) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Vec3& p : one.positions)
      all.positions.push_back({p.x + 2 * (i % columns), p.y + 2 * (i / columns), p.z});
    all.face_sizes.insert(all.face_sizes.end(), one.face_sizes.begin(), one.face_sizes.end());
    for (const std::uint32_t k : one.indices) all.indices.push_back(first + k);
  }
  return all;
}

Pair flush_pegs(std::size_t n) {
  const std::uint32_t columns = root(n);
  const PolygonMesh peg = block({0.5, 0.5, 0}, {1.5, 1.5, 1}).to_mesh();
  return {Solid::from_mesh(in_grid(peg, columns)), plate(columns, -1, 0)};
}

TEST(Growth, PegsFlushOnAPlate) {
  EXPECT_LT(growth([](std::size_t n) { return unite(flush_pegs(n)); }, 400), n_log_n);
}

// A long block beside n short ones in a row: its edges lie in the planes of all their faces.
TEST(Growth, BlocksInARowFlushWithALongOne) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  PolygonMesh row;
                  const auto count = static_cast<std::uint32_t>(n);
                  for (std::uint32_t i = 0; i < count; ++i) {
                    const PolygonMesh one = block({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}).to_mesh();
                    for (const std::uint32_t k : one.indices)
                      row.indices.push_back(k + static_cast<std::uint32_t>(row.positions.size()));
                    row.positions.insert(row.positions.end(), one.positions.begin(),
                                         one.positions.end());
                    row.face_sizes.insert(row.face_sizes.end(), one.face_sizes.begin(),
                                          one.face_sizes.end());
                  }
                  return unite({Solid::from_mesh(row), block({-1, 1, 0}, {2.0 * count, 2, 1})});
                },
                200),
            n_log_n);
}

// A cylinder whose ends are rings in one plane: between any two of them runs a flat edge.
Solid ringed(std::uint32_t sides, std::uint32_t rings, double low, double high, double turn) {
  PolygonMesh mesh;
  const auto ring = [&](double radius, double z) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + turn) / sides;
      mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return first;
  };
  const auto add = [&](std::initializer_list<std::uint32_t> corners) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    mesh.indices.insert(mesh.indices.end(), corners);
  };
  std::uint32_t outermost[2] = {0, 0};
  for (const bool top : {false, true}) {
    std::uint32_t inner = 0;
    for (std::uint32_t r = 1; r <= rings; ++r) {
      const std::uint32_t outer = ring(double(r) / rings, top ? high : low);
      for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t j = (i + 1) % sides;
        if (r == 1) {
          if (i > 1)
            top ? add({outer, outer + i - 1, outer + i}) : add({outer, outer + i, outer + i - 1});
        } else {
          top ? add({inner + i, outer + i, outer + j}) : add({inner + i, outer + j, outer + i});
          top ? add({inner + i, outer + j, inner + j}) : add({inner + i, inner + j, outer + j});
        }
      }
      inner = outer;
    }
    outermost[top] = inner;
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    add({outermost[0] + i, outermost[0] + j, outermost[1] + j, outermost[1] + i});
  }
  return Solid::from_mesh(mesh);
}

TEST(Growth, DiscsFlushInRings) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const auto sides = static_cast<std::uint32_t>(n);
                  return unite({ringed(sides, 3, 0, 1, 0), ringed(sides, 3, 1, 2, 0.5)});
                },
                100),
            n_log_n);
}

// Hexagonal tubes around each other, which all stand on one floor.
Solid tubes_in_tubes(std::uint32_t count) {
  PolygonMesh all;
  for (std::uint32_t i = 1; i <= count; ++i) {
    const Solid tube = boolean(prism(i + 0.5, 1, 6), prism(i, 1, 6), Operation::subtract);
    test::append(tube.to_mesh(), all);
  }
  return Solid::from_mesh(all);
}

TEST(Growth, TubesInTubesOnAFloor) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const auto count = static_cast<std::uint32_t>(n);
                  const double size = count + 2;
                  return unite({tubes_in_tubes(count), block({-size, -size, -1}, {size, size, 0})});
                },
                50),
            1.6);
}

TEST(Growth, SmallTetrahedraInASlantedOne) {
  EXPECT_LT(
      growth(
          [](std::size_t n) {
            const std::uint32_t columns = root(n);
            const double size = 2.0 * columns;
            const PolygonMesh small{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                    {3, 3, 3, 3},
                                    {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
            const PolygonMesh large{{{-size, -size, -2 * size},
                                     {3 * size, -size, 2 * size},
                                     {-size, 3 * size, 2 * size},
                                     {-size, -size, 2 * size}},
                                    {3, 3, 3, 3},
                                    {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
            const Pair pair{Solid::from_mesh(large), Solid::from_mesh(in_grid(small, columns))};
            return [pair] { boolean(pair.a, pair.b, Operation::subtract); };
          },
          1000),
      n_log_n);
}

// Prisms that are twisted one way and the other, one in the other: all boxes overlap, no faces.
TEST(Growth, NeedlesBesideNeedles) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  return unite({test::needles(n, 1, 1, 2), test::needles(n, 0.9, 0.9, -2)});
                },
                500),
            n_log_n);
}

// Solids that nothing of the other operand cuts.

Solid trusted(const PolygonMesh& mesh) {
  ImportOptions options;
  options.trusted = true;
  return Solid::from_mesh(mesh, options);
}

// With its first three corners clockwise, seen from the fourth one.
void add_tetrahedron(PolygonMesh& mesh, const std::array<Vec3, 4>& corners) {
  const auto o = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 0u, 3u, 2u})
    mesh.indices.push_back(o + k);
  mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
}

Vec3 around_z(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// From the z axis outwards, each in half of its part of a turn.
Solid walls(std::size_t n) {
  PolygonMesh mesh;
  const auto add_face = [&](std::initializer_list<std::uint32_t> corners) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    mesh.indices.insert(mesh.indices.end(), corners);
  };
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = step * static_cast<double>(i), b = a + step / 2;
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double z : {0.0, 1.0})
      for (const Vec3& p : {Vec3{0, 0, z}, around_z(1, a, z), around_z(1, b, z)})
        mesh.positions.push_back(p);
    add_face({o, o + 2, o + 1});
    add_face({o + 3, o + 4, o + 5});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      add_face({o + k, o + next, o + 3 + next, o + 3 + k});
    }
  }
  return trusted(mesh);
}

// In the gaps between such walls.
Solid spikes_between_walls(std::size_t n) {
  PolygonMesh mesh;
  const double step = 2 * std::numbers::pi / static_cast<double>(n), width = step / 50;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = step * (static_cast<double>(i) + 0.75);
    add_tetrahedron(mesh, {around_z(0.2, a, 0.45), around_z(0.9, a - width, 0.45),
                           around_z(0.9, a + width, 0.45), around_z(0.9, a, 0.55)});
  }
  return trusted(mesh);
}

// Teeth and gaps of the same width.
Solid short_comb(std::size_t teeth) {
  const double length = static_cast<double>(teeth);
  Profile comb;
  comb.outer = {{-1, -1}, {length + 1, -1}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = static_cast<double>(i);
    comb.outer.insert(comb.outer.end(), {{x + 0.5, 0}, {x + 0.5, 1}, {x, 1}, {x, 0}});
  }
  return extrude(comb, 1);
}

// In all teeth of such a comb, and between them.
Solid crumbs(std::size_t teeth) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < 2 * teeth; ++i) {
    const double x = static_cast<double>(i) / 2 + 0.2;
    add_tetrahedron(
        mesh, {Vec3{x, 0.4, 0.4}, Vec3{x + 0.1, 0.4, 0.4}, Vec3{x, 0.5, 0.4}, Vec3{x, 0.4, 0.5}});
  }
  return trusted(mesh);
}

double growth_of_uncut(Solid (*large)(std::size_t), Solid (*small)(std::size_t), double degrees,
                       std::size_t n) {
  return growth(
      [&](std::size_t size) {
        const Transform turn = Transform::rotation_degrees({0.3, -0.5, 0.7}, degrees);
        return unite({transformed(large(size), turn), transformed(small(size), turn)});
      },
      n);
}

TEST(Growth, SpikesBetweenWallsAroundOneLine) {
  for (const double degrees : {0.0, 33.0})
    EXPECT_LT(growth_of_uncut(walls, spikes_between_walls, degrees, 1000), n_log_n);
}

TEST(Growth, CrumbsInTheTeethOfACombAndBetweenThem) {
  for (const double degrees : {0.0, 33.0})
    EXPECT_LT(growth_of_uncut(short_comb, crumbs, degrees, 250), n_log_n);
}

// Of what two versions have in common, blocks that they share are not looked into, and faces that
// they do not share are looked at, but not cut.
double steps_of_versions_for_each_face(const std::function<Pair(std::size_t)>& versions) {
  const auto steps = [&](std::size_t n) {
    const Pair pair = versions(n);
    boolean(pair.a, pair.b, Operation::subtract);  // finds what blocks keep
    return static_cast<double>(steps_of([&] { boolean(pair.a, pair.b, Operation::subtract); }));
  };
  return (steps(80000) - steps(20000)) / 60000;
}

PolygonMesh ball(std::size_t n) {
  const std::uint32_t rings = root(n / 4);
  return sphere_mesh({0, 0, 0}, 1, 2 * rings, rings);
}

TEST(Growth, ASolidBesideWhatIsLeftOfItAfterASmallCut) {
  const Solid tool = transformed(block({0.9, -0.05, -0.05}, {1.2, 0.05, 0.05}),
                                 Transform::rotation_degrees({1, 2, 3}, 40));
  const auto versions = [&](std::size_t n) -> Pair {
    const Solid all = Solid::from_mesh(ball(n));
    return {all, boolean(all, tool, Operation::subtract)};
  };
  EXPECT_LT(steps_of_versions_for_each_face(versions), 60);
}

TEST(Growth, TwoVersionsOfAMeshOfWhichOneHasASmallDent) {
  const auto versions = [](std::size_t n) -> Pair {
    PolygonMesh mesh = ball(n);
    const Solid all = Solid::from_mesh(mesh);
    for (Vec3& p : mesh.positions)
      if (p.x > 0.998) p.x -= 0.01;
    return {all, Solid::from_mesh(mesh)};
  };
  EXPECT_LT(steps_of_versions_for_each_face(versions), 2500);
}

// Four times as many faces make it twice as long.
TEST(Growth, SectionsOfAFineSolid) {
  const auto section_of_ball = [](std::size_t n) {
    const auto work = [solid = Solid::from_mesh(ball(n))] { section(solid, {0.1, 0.2, 1, 0.1}); };
    work();  // finds what blocks keep
    return work;
  };
  EXPECT_LT(growth(section_of_ball, 40000), 0.65);
}

}  // namespace
}  // namespace sectile
