// The area of a loop in a plane, and which way it turns.
#pragma once

#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// Twice the signed area of a loop's projection to the axes i and j, with a bound for all rounding.
Estimate estimated_area(const Geometry& geometry, const std::vector<PointId>& loop, int i, int j);

/// Is a loop of a plane counter-clockwise, seen against the plane's normal? Neighbouring points
/// differ in place. Loops that touch themselves are allowed.
bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop);

}  // namespace sectile
