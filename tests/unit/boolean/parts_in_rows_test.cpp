// Many parts in a row, with corners and edges on common lines, that touch nowhere: each is inside
// the other solid or outside of it, which only rays tell.
#include <gtest/gtest.h>

#include <algorithm>

#include "append_mesh.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

constexpr int count = 40;

enum class Way { along_x, along_y, along_z, slanted };

// By a matrix of integers: what lies in a plane or on a line stays there.
PolygonMesh turned(PolygonMesh mesh, Way way) {
  for (Vec3& p : mesh.positions) {
    const Vec3 q = p;
    if (way == Way::along_y) p = {q.z, q.x, q.y};
    if (way == Way::along_z) p = {q.y, q.z, q.x};
    if (way == Way::slanted) p = {3 * q.x - 4 * q.y, 4 * q.x + 3 * q.y, 5 * q.z};
  }
  return mesh;
}
double larger(Way way) {
  return way == Way::slanted ? 125 : 1;
}

void add_block(const Vec3& low, const Vec3& high, PolygonMesh& mesh) {
  test::append(block(low, high).to_mesh(), mesh);
}

// Hollow boxes of volume 9³ - 7³.
PolygonMesh boxes() {
  PolygonMesh mesh;
  for (int i = 0; i < count; ++i) {
    const double x = 10 * i;
    add_block({x, 0, 0}, {x + 9, 9, 9}, mesh);
    PolygonMesh cavity = block({x + 1, 1, 1}, {x + 8, 8, 8}).to_mesh();
    std::size_t first = 0;
    for (const std::uint32_t size : cavity.face_sizes) {
      std::reverse(cavity.indices.begin() + static_cast<std::ptrdiff_t>(first),
                   cavity.indices.begin() + static_cast<std::ptrdiff_t>(first + size));
      first += size;
    }
    test::append(cavity, mesh);
  }
  return mesh;
}
constexpr double of_boxes = count * (9 * 9 * 9 - 7 * 7 * 7);

// One within the material of each box, one in its cavity, and one behind it.
PolygonMesh crumbs() {
  PolygonMesh mesh;
  for (int i = 0; i < count; ++i) {
    const double x = 10 * i;
    add_block({x + 0.25, 0.25, 0.25}, {x + 0.75, 0.75, 0.75}, mesh);
    add_block({x + 2, 2, 2}, {x + 5, 5, 5}, mesh);
    add_block({x + 9.25, 0.25, 0.25}, {x + 9.75, 0.75, 0.75}, mesh);
  }
  return mesh;
}
constexpr double within = count * 0.125, outside = count * (0.125 + 27);

class PartsInRows : public testing::TestWithParam<Way> {
 protected:
  static Solid solid(const PolygonMesh& mesh) { return Solid::from_mesh(turned(mesh, GetParam())); }
  static void expect_volume(const Solid& solid, double volume) {
    volume *= larger(GetParam());
    EXPECT_NEAR(solid.volume(), volume, 1e-12 * volume);
  }
  static void expect(const Solid& solid, double volume, std::size_t shells) {
    expect_volume(solid, volume);
    EXPECT_EQ(solid.counts().shells, shells);
  }
};

TEST_P(PartsInRows, AreInsideTheOtherSolidOrOutside) {
  const Solid a = solid(boxes()), b = solid(crumbs());
  expect(boolean(a, b, Operation::unite), of_boxes + outside, 4 * count);
  expect(boolean(b, a, Operation::unite), of_boxes + outside, 4 * count);
  expect(boolean(a, b, Operation::intersect), within, count);
  expect(boolean(a, b, Operation::subtract), of_boxes - within, 3 * count);
  expect(boolean(b, a, Operation::subtract), outside, 2 * count);
}

TEST_P(PartsInRows, AreOfTheCellsInWhichTheyLie) {
  const auto all = cells(std::vector<Solid>{solid(boxes()), solid(crumbs())});
  ASSERT_EQ(all.size(), 3u);
  for (const SolidCell& cell : all) {
    const bool in_a = std::ranges::count(cell.operands, 0u) > 0,
               in_b = std::ranges::count(cell.operands, 1u) > 0;
    expect_volume(cell.solid, in_a && in_b ? within : in_a ? of_boxes - within : outside);
  }
}

// Blocks that cross each other elsewhere: all cells are found then.
TEST_P(PartsInRows, AreRepairedByTheirWindings) {
  PolygonMesh mesh = boxes();
  test::append(crumbs(), mesh);
  add_block({-4, -4, -4}, {-2, -2, -2}, mesh);
  add_block({-3, -3, -3}, {-1, -1, -1}, mesh);
  RepairOptions options;
  expect_volume(repair(turned(mesh, GetParam()), options), of_boxes + outside + 15);
  options.rule = Rule::odd;
  expect_volume(repair(turned(mesh, GetParam()), options), of_boxes - within + outside + 14);
}

std::string name_of(const testing::TestParamInfo<Way>& way) {
  constexpr const char* names[] = {"AlongX", "AlongY", "AlongZ", "Slanted"};
  return names[static_cast<int>(way.param)];
}

INSTANTIATE_TEST_SUITE_P(All, PartsInRows,
                         testing::Values(Way::along_x, Way::along_y, Way::along_z, Way::slanted),
                         name_of);

}  // namespace
}  // namespace sectile
