// Lines of edges and points on them.
#pragma once

#include <utility>

#include "boolean/workspace.h"

namespace sectile {

/// Two planes that meet in the line of a half-edge.
std::pair<PlaneId, PlaneId> line_planes(const Patch& patch, HalfEdgeId h);

/// The point in which a plane cuts the line of a half-edge of an operand.
Construction edge_plane_construction(const Workspace& w, Operand operand, HalfEdgeId h,
                                     PlaneId plane);

}  // namespace sectile
