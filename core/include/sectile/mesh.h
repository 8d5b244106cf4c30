// Polygon meshes: how solids come in and go out.
#pragma once

#include <cstdint>
#include <vector>

namespace sectile {

/// A point in space. Doubles are taken as the exact numbers that they are; the unit is the
/// caller's.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Polygons without holes, counter-clockwise as seen from outside the solid.
struct PolygonMesh {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> face_sizes;  ///< corners of each face
  std::vector<std::uint32_t> indices;     ///< all faces' corners, one after another
};

}  // namespace sectile
