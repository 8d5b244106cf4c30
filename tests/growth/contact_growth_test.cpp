// Booleans of solids that come near each other in many places, or only in boxes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

}  // namespace
}  // namespace sectile
