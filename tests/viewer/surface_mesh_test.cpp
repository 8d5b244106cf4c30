// Solids and parts of them as triangles to draw.
#include "picture/surface_mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "sectile/sectile.h"

namespace sectile::viewer {
namespace {

TEST(SurfaceMesh, BlockHasTwelveHardEdges) {
  const auto mesh = surface_mesh(block({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(mesh->faces.size(), 12u);
  EXPECT_EQ(mesh->hard_edges.size(), 24u);
  EXPECT_EQ(mesh->bounds.high, glm::dvec3(1, 2, 3));
}

TEST(SurfaceMesh, NormalsPointOutwards) {
  const auto mesh = surface_mesh(sphere(1, 16, 8));
  for (std::size_t i = 0; i < mesh->positions.size(); ++i)
    EXPECT_GT(glm::dot(mesh->positions[i], mesh->normals[i]), 0);
}

// Their faces have the same sources, but meet in edges.
TEST(SurfaceMesh, ABlockWithItsTurnedCopyHasAllItsHardEdges) {
  const Solid bar = block({-2, -0.5, -0.5}, {2, 0.5, 0.5});
  const Solid cross = boolean(
      bar, transformed(bar, Transform{{0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0}}), Operation::unite);
  const SurfacePart part = classify(cross, block({5, 5, 5}, {6, 6, 6})).a_out_b;
  EXPECT_EQ(surface_mesh(part)->hard_edges.size(), 2 * cross.counts().edges);
  EXPECT_EQ(surface_mesh(cross)->hard_edges.size(), 2 * cross.counts().edges);
}

TEST(SurfaceMesh, PartsWithHolesAreTriangulatedWhole) {
  const Solid plate = block({-2, -2, -1}, {2, 2, 1}), rod = cylinder(1, 4, 24);
  const Solid moved = transformed(rod, Transform::translation({0, 0, -2}));
  const SurfacePart part = classify(plate, moved).a_out_b;
  const auto mesh = surface_mesh(part);
  double area = 0;
  for (std::size_t t = 0; t < mesh->faces.size(); ++t) {
    const glm::vec3* p = &mesh->positions[3 * t];
    const glm::vec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    EXPECT_GT(glm::dot(n, mesh->normals[3 * t]), 0);
    area += 0.5 * static_cast<double>(glm::length(n));
  }
  EXPECT_NEAR(area, part.area, 1e-4);
  // Twelve edges of the plate, two rings of 24.
  EXPECT_EQ(mesh->hard_edges.size(), 2u * (12 + 48));
}

}  // namespace
}  // namespace sectile::viewer
