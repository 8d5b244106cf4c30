// How often a mesh goes around a point, exactly: the faces that a ray meets are counted, with long
// doubles and an error bound, then with rationals. Nothing of the library is asked.
#pragma once

#include <optional>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

/// The triangles of a mesh, polygons as fans around their first corners: over all of a closed mesh
/// the choice makes no difference where polygons are plane.
class ExactWinding {
 public:
  explicit ExactWinding(const PolygonMesh& mesh);

  /// Nothing if the point is on a face.
  std::optional<int> operator()(const Vec3& point) const;

 private:
  struct Triangle {
    Vec3 a, b, c;
  };
  std::vector<Triangle> triangles_;
};

}  // namespace sectile::test
