// Cosines and sines with the symmetries of the circle kept exactly.
#pragma once

#include <cstdint>

#include "sectile/primitives.h"

namespace sectile {

/// (cos, sin) of an angle, computed in the first octant and mirrored from there: multiples of 90°
/// give exactly 0 and ±1, the other multiples of 30° exactly ±0.5 where the value is that, and
/// mirrored angles exactly mirrored points. The angle must be finite.
Vec2 unit_vector(double degrees);

/// The k-th of n points evenly spaced on the unit circle, counter-clockwise from (1, 0).
Vec2 circle_point(std::uint64_t k, std::uint64_t n);

}  // namespace sectile
