// Moving a solid to corners that are doubles again.
#pragma once

#include <optional>

#include "sectile/solid.h"

namespace sectile {

/// For who places solids by their corners, as snapping does: each corner goes to the doubles
/// nearest to its image, while transformed() is exact and may lead it between them. The faces are
/// imported again: those that rounding makes non-planar fall into triangles. They keep their
/// FaceSource. Nothing if a corner of the solid itself is not given as three doubles (after a
/// Boolean, say): then only transformed() keeps the faces as they are. Throws InvalidSolid if
/// rounding makes faces cross.
std::optional<Solid> rounded_move(const Solid& solid, const Vec3& by);

}  // namespace sectile
