// Boxes around moved solids.
#pragma once

#include "picture/camera.h"

namespace sectile::viewer {

/// A box around the moved corners of a box.
Bounds moved(const Bounds& bounds, const glm::dmat4& by);

}  // namespace sectile::viewer
