// Which side of a surface the material is on.
#pragma once

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// Does the surface certainly enclose a volume that is not negative? Doubles may not tell.
bool encloses_volume(const TriangleMesh& mesh);

}  // namespace sectile
