// The straight way of a large mesh of triangles into blocks: see triangle_mesh.h.
#pragma once

#include <memory>

#include "import/polygons.h"
#include "import/steps.h"
#include "storage/solid_data.h"

namespace sectile {

/// The boundary that such a mesh is. None if it is anything else, or small; whether that is a solid
/// the general way finds out. Throws InvalidSolid as that does, where faces cross or are folded.
std::shared_ptr<SolidData> read_triangles(const SoupView& soup, const ImportOptions& options,
                                          const ImportSteps& steps);

}  // namespace sectile
