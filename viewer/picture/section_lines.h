// Where a plane cuts a surface.
#pragma once

#include <vector>

#include "picture/picture.h"

namespace sectile::viewer {

/// The segments, two ends for each, in the world; moved a little to the side that a section keeps,
/// by `aside`, so that they are not cut away themselves. Faces in the plane give none.
std::vector<glm::vec3> section_lines(const SurfaceMesh& mesh, const glm::dmat4& model,
                                     const glm::dvec4& plane, double aside);

}  // namespace sectile::viewer
