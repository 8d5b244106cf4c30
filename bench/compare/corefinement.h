// CGAL's corefinement on the same triangles.
#pragma once

#include "sectile/boolean.h"
#include "sectile/mesh.h"

namespace sectile::bench {

struct Measured {
  bool made = false;          ///< else the engine refused
  double import_seconds = 0;  ///< both operands, from triangles to the engine's structure
  double boolean_seconds = 0;
  double peak_memory = 0;  ///< MiB
  double volume = 0;
};

Measured corefinement(const PolygonMesh& a, const PolygonMesh& b, Operation operation);

}  // namespace sectile::bench
