// Corners that lie on edges of other sheets.
#pragma once

#include <functional>

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Divides each edge at the corners of the surface that lie on it, where `moves` of any of these
/// points. Rounding moves each point on a line its own way: what only touches an edge would get
/// beyond it. What has the point as a corner, too, goes with it. No mate is partial.
void divide_on_common_lines(TriangleSurface& surface, const Kernel& kernel,
                            const std::function<bool(PointId)>& moves);

}  // namespace sectile
