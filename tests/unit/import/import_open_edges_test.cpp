// Faces whose edges are longer than those of their neighbours.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

const Solid cube = block({0, 0, 0}, {1, 1, 1});

Solid cube_with(std::initializer_list<Vec3> more,
                std::initializer_list<std::pair<std::size_t, std::vector<std::uint32_t>>> changed) {
  std::vector<Vec3> positions = cube_mesh().positions;
  positions.insert(positions.end(), more);
  auto faces = faces_of(cube_mesh());
  for (const auto& [number, face] : changed) faces[number] = face;
  return Solid::from_mesh(with_faces(positions, faces));
}

void expect_cube(const Solid& solid) {
  EXPECT_TRUE(validate(solid).empty());
  EXPECT_EQ(solid, cube);
}

TEST(ImportOpenEdges, ACornerThatANeighbourLacks) {
  expect_cube(cube_with({{0.5, 0, 1}}, {{1, {4, 8, 5, 6, 7}}}));
}

TEST(ImportOpenEdges, CornersThatEachOfTwoNeighboursLacks) {
  expect_cube(cube_with({{0.25, 0, 1}, {0.75, 0, 1}, {0.5, 0, 1}},
                        {{1, {4, 8, 9, 5, 6, 7}}, {2, {0, 1, 5, 10, 4}}}));
}

TEST(ImportOpenEdges, ACornerBesideTheEdgeDoesNotCount) {
  EXPECT_THROW(cube_with({{0.5, 0, std::nextafter(1, 2)}}, {{1, {4, 8, 5, 6, 7}}}), InvalidSolid);
}

TEST(ImportOpenEdges, AHoleAtSuchAnEdgeIsStillAHole) {
  EXPECT_THROW(cube_with({{0.5, 0, 1}}, {{1, {4, 8, 6, 7}}}), InvalidSolid);
}

// Each side of the cube cut into rectangles of its own.
class CutSides {
 public:
  explicit CutSides(unsigned seed) : random_(seed) {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool far : {false, true}) cut(axis, far, {0, 0}, {64, 64});
  }
  const PolygonMesh& mesh() const { return mesh_; }

 private:
  struct Uv {
    int u, v;
  };

  void cut(int axis, bool far, Uv low, Uv high) {
    const int wide = high.u - low.u, tall = high.v - low.v;
    const int size = std::max(wide, tall);
    if (size < 4 || random_() % 4 == 0) return add(axis, far, low, high);
    const int at = 1 + static_cast<int>(random_() % static_cast<unsigned>(size - 1));
    Uv middle_high = high, middle_low = low;
    if (wide > tall)
      middle_high.u = middle_low.u = low.u + at;
    else
      middle_high.v = middle_low.v = low.v + at;
    cut(axis, far, low, middle_high);
    cut(axis, far, middle_low, high);
  }

  void add(int axis, bool far, Uv low, Uv high) {
    const Uv counter_clockwise[] = {low, {high.u, low.v}, high, {low.u, high.v}};
    mesh_.face_sizes.push_back(4);
    for (int i = 0; i < 4; ++i) {
      const Uv c = counter_clockwise[far ? i : 3 - i];
      double xyz[3];
      xyz[axis] = far ? 1 : 0;
      xyz[(axis + 1) % 3] = c.u / 64.0;
      xyz[(axis + 2) % 3] = c.v / 64.0;
      mesh_.indices.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
      mesh_.positions.push_back({xyz[0], xyz[1], xyz[2]});
    }
  }

  std::mt19937 random_;
  PolygonMesh mesh_;
};

TEST(ImportOpenEdges, SidesCutIntoRectanglesOfTheirOwn) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Solid solid = Solid::from_mesh(CutSides(seed).mesh());
    expect_cube(solid);
    EXPECT_EQ(boolean(solid, block({0.5, 0.5, 0.5}, {2, 2, 2}), Operation::subtract).volume(),
              0.875);
  }
}

}  // namespace
}  // namespace sectile
