#include "corefinement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <vector>

#include "peak_memory.h"

namespace sectile::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
namespace pmp = CGAL::Polygon_mesh_processing;

Mesh imported(const PolygonMesh& triangles) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  vertices.reserve(triangles.positions.size());
  for (const Vec3& p : triangles.positions) vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
    mesh.add_face(vertices[triangles.indices[i]], vertices[triangles.indices[i + 1]],
                  vertices[triangles.indices[i + 2]]);
  return mesh;
}

bool combine(Mesh& a, Mesh& b, Operation operation, Mesh& result) {
  switch (operation) {
    case Operation::unite:
      return pmp::corefine_and_compute_union(a, b, result);
    case Operation::intersect:
      return pmp::corefine_and_compute_intersection(a, b, result);
    case Operation::subtract:
      return pmp::corefine_and_compute_difference(a, b, result);
  }
  return false;
}

}  // namespace

Measured corefinement(const PolygonMesh& a, const PolygonMesh& b, Operation operation) {
  reset_peak_memory();
  Measured measured;
  const auto start = Clock::now();
  Mesh a_mesh = imported(a), b_mesh = imported(b), result;
  const auto imported_at = Clock::now();
  measured.made = combine(a_mesh, b_mesh, operation, result);
  const auto end = Clock::now();
  measured.import_seconds = Seconds(imported_at - start).count();
  measured.boolean_seconds = Seconds(end - imported_at).count();
  measured.peak_memory = peak_memory();
  if (measured.made) measured.volume = CGAL::to_double(pmp::volume(result));
  return measured;
}

}  // namespace sectile::bench
