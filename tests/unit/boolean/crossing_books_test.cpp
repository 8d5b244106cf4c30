// Books of walls that end elsewhere along their line, slanted, flush here and there, and that meet
// each other off the line, too: Booleans against the cells of an arrangement of all faces, which
// leaves nothing out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "cases.h"
#include "sectile/arrangement.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

/// Between two points of the line and one of each of two half-planes.
struct Wall {
  double low, high;
  Vec3 first, second;
};

Solid book(const std::vector<Wall>& walls) {
  PolygonMesh mesh;
  for (const Wall& wall : walls) {
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    const Vec3 corners[] = {{0, 0, wall.low}, {0, 0, wall.high}, wall.first, wall.second};
    mesh.positions.insert(mesh.positions.end(), std::begin(corners), std::end(corners));
    for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u})
      mesh.indices.push_back(o + k);
    mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
  }
  return repair(mesh);
}

void expect_what_cells_are(const Solid& a, const Solid& b) {
  Solid only_a, only_b, both;
  for (const SolidCell& cell : cells(std::vector<Solid>{a, b}))
    (cell.operands.size() == 2 ? both : cell.operands[0] == 0 ? only_a : only_b) = cell.solid;
  const Solid any = boolean(a, b, Operation::unite);
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == only_a);
  EXPECT_TRUE(boolean(b, a, Operation::subtract) == only_b);
  EXPECT_TRUE(boolean(a, b, Operation::intersect) == both);
  EXPECT_TRUE(boolean(any, b, Operation::subtract) == only_a);
  EXPECT_NEAR(any.volume(), only_a.volume() + only_b.volume() + both.volume(),
              1e-12 * any.volume());
  EXPECT_TRUE(validate(any).empty());
}

Solid random_book(std::mt19937& random, int count) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto corner = [&](int at) {
    const double angle = 2 * std::acos(-1.0) * at / 120;
    return Vec3{std::round(64 * std::cos(angle)), std::round(64 * std::sin(angle)),
                double(below(80))};
  };
  std::vector<Wall> walls;
  for (int i = 0; i < count; ++i) {
    const int at = below(120), end = at + 1 + below(3);
    const double low = below(40);
    const Vec3 first = corner(at), second = corner(end);
    walls.push_back({low, low + 1 + below(40), first, second});
  }
  return book(walls);
}

TEST(CrossingBooks, AreWhatTheirCellsAre) {
  for (unsigned seed = 0; seed < cases(12u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const int count = 8 + 2 * int(seed % 6);
    const Solid a = random_book(random, count), b = random_book(random, count);
    const Transform turn = Transform::rotation_degrees({1, 2, 3}, seed % 3 * 20.0);
    expect_what_cells_are(transformed(a, turn), transformed(b, turn));
  }
}

// A wall of A is in a gap of more than half a turn between walls of B, and, as faces of B have
// several edges on the line, is seen beside a smaller gap as well, in which it is not.
TEST(CrossingBooks, AWallInAWideGapIsNotInTheMaterialBeyondANarrowOne) {
  expect_what_cells_are(book({{4, 29, {0, 64, 26}, {-7, 64, 27}},
                              {18, 58, {54, -35, 63}, {55, -32, 10}},
                              {37, 51, {20, 61, 74}, {13, 63, 75}},
                              {10, 29, {-64, -3, 26}, {-63, -13, 42}},
                              {19, 56, {48, 43, 34}, {40, 50, 0}},
                              {35, 55, {-40, -50, 41}, {-32, -55, 45}},
                              {10, 43, {-13, -63, 11}, {-7, -64, 71}},
                              {33, 43, {-62, 17, 25}, {-64, 7, 68}},
                              {29, 43, {58, -26, 56}, {62, -17, 39}},
                              {35, 47, {64, 0, 62}, {64, 3, 12}}}),
                        book({{3, 22, {-52, -38, 23}, {-45, -45, 39}},
                              {37, 40, {-29, -57, 62}, {-20, -61, 54}},
                              {21, 57, {-50, 40, 73}, {-54, 35, 7}},
                              {22, 54, {26, 58, 58}, {20, 61, 73}},
                              {5, 17, {17, -62, 76}, {20, -61, 40}},
                              {37, 42, {-62, 17, 37}, {-64, 7, 37}},
                              {16, 36, {-63, 10, 8}, {-64, 3, 62}},
                              {38, 64, {-20, 61, 22}, {-29, 57, 35}},
                              {29, 51, {63, 13, 45}, {60, 23, 54}},
                              {37, 53, {3, 64, 24}, {0, 64, 21}},
                              {30, 40, {0, -64, 42}, {3, -64, 25}},
                              {25, 55, {50, -40, 37}, {54, -35, 77}},
                              {20, 34, {13, 63, 67}, {3, 64, 78}}}));
}

}  // namespace
}  // namespace sectile
