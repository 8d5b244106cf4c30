// Corners that lie on edges of other sheets.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/edges_by_line.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// An edge, by the numbers of its points, and a corner within it.
struct CornerOnEdge {
  PointPair edge;
  PointId corner;
  friend auto operator<=>(const CornerOnEdge&, const CornerOnEdge&) = default;
};
/// Those of a surface, ascending, but for such as nothing near by `moves`. No mate is partial.
std::vector<CornerOnEdge> corners_on_edges(const TriangleSurface& surface, const Kernel& kernel,
                                           const std::function<bool(PointId)>& moves);

/// Divides each edge at the corners of the surface that lie on it, where `moves` of any of these
/// points. Rounding moves each point on a line its own way: what only touches an edge would get
/// beyond it. What has the point as a corner, too, goes with it. No mate is partial.
void divide_on_common_lines(TriangleSurface& surface, const Kernel& kernel,
                            const std::function<bool(PointId)>& moves);
/// The same where all corners on edges are known.
void divide_on_common_lines(TriangleSurface& surface, const Kernel& kernel,
                            const std::function<bool(PointId)>& moves,
                            std::span<const CornerOnEdge> on_edges);

}  // namespace sectile
