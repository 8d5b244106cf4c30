// Does a mesh enclose volume?
#pragma once

#include <cstdint>
#include <span>

#include "sectile/mesh.h"

namespace sectile {

/// Certainly: the sum over the triangles, of three indices each, is far more than its rounding
/// errors.
bool clearly_encloses_volume(std::span<const Vec3> positions,
                             std::span<const std::uint32_t> indices);

}  // namespace sectile
