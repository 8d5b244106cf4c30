// A transform as an exact map.
#pragma once

#include "geometry/frame.h"
#include "sectile/transform.h"

namespace sectile {

/// Throws std::invalid_argument for a matrix that is singular or not finite.
Frame checked_frame(const Transform& transform);
/// Throws std::invalid_argument for a map that flattens.
void require_invertible(const Frame& frame);

}  // namespace sectile
