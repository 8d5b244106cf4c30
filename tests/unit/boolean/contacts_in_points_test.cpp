// Solids that meet in single points only.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "volumes.h"

namespace sectile {
namespace {

using test::expect_volumes;

Solid tetrahedron(const std::array<Vec3, 4>& p) {
  PolygonMesh mesh;
  mesh.positions.assign(p.begin(), p.end());
  mesh.face_sizes = {3, 3, 3, 3};
  mesh.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  return Solid::from_mesh(mesh);
}

TEST(ContactsInPoints, ATetrahedronThatTouchesABlockFromWithinInAllItsVertices) {
  // Its corners lie in the middles of four faces.
  const Solid inner = tetrahedron({Vec3{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, 0, -2}});
  expect_volumes(block({-2, -2, -2}, {2, 2, 2}), inner, inner.volume());
}

TEST(ContactsInPoints, ATetrahedronInTheCornersOfABlock) {
  const Solid inner = tetrahedron({Vec3{0, 0, 0}, {3, 0, 3}, {3, 3, 0}, {0, 3, 3}});
  expect_volumes(block({0, 0, 0}, {3, 3, 3}), inner, inner.volume());
}

TEST(ContactsInPoints, ATetrahedronInACavityThatItTouchesInAllItsVertices) {
  const Solid shell =
      boolean(block({-4, -4, -4}, {4, 4, 4}), block({-2, -2, -2}, {2, 2, 2}), Operation::subtract);
  const Solid inner = tetrahedron({Vec3{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, 0, -2}});
  expect_volumes(shell, inner, 0);
}

TEST(ContactsInPoints, AnOctahedronStandsOnTheMiddlesOfTheFacesOfABlock) {
  PolygonMesh mesh;
  mesh.positions = {{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}};
  mesh.face_sizes.assign(8, 3);
  mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  const Solid octahedron = Solid::from_mesh(mesh);
  expect_volumes(block({-2, -2, -2}, {2, 2, 2}), octahedron, octahedron.volume());
}

TEST(ContactsInPoints, BlocksThatTouchInACorner) {
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        expect_volumes(block({0, 0, 0}, {1, 1, 1}), block({x, y, z}, {x + 1, y + 1, z + 1}), 0);
}

}  // namespace
}  // namespace sectile
