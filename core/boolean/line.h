// Lines of edges and points on them.
#pragma once

#include <utility>

#include "boolean/workspace.h"

namespace sectile {

/// Two planes that meet in the line of a half-edge.
std::pair<PlaneId, PlaneId> line_planes(const Patch& patch, HalfEdgeId h);

/// The point in which a plane cuts the line of a half-edge of solid s.
Construction edge_plane_construction(const Workspace& w, int s, HalfEdgeId h, PlaneId plane);
inline Construction edge_plane_construction(const Workspace& w, Operand operand, HalfEdgeId h,
                                            PlaneId plane) {
  return edge_plane_construction(w, static_cast<int>(operand), h, plane);
}

}  // namespace sectile
