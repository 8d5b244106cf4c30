// Whether points are in a solid as the winding numbers of the mesh say from which it was made:
// computed from solid angles, with nothing of the library.
#pragma once

#include <cstddef>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

struct Agreement {
  std::size_t points = 0;     ///< asked about
  std::size_t wrong = 0;      ///< in the solid, but not by the winding number, or the other way
  std::size_t undecided = 0;  ///< too near to a face for solid angles
};

/// Points around the mesh and close to its faces. Material is where the winding number is positive,
/// or negative if `turned`.
Agreement check_points(const PolygonMesh& mesh, bool turned, const PolygonMesh& solid,
                       std::size_t points);

/// Points around a mesh, half of them close to its faces.
std::vector<Vec3> sample_points(const PolygonMesh& mesh, std::size_t count);

/// The number of times that a surface goes around a point, from solid angles.
double winding_number(const PolygonMesh& mesh, const Vec3& point);

}  // namespace sectile::test
