// Where a boundary touches itself.
#pragma once

#include <vector>

#include "topology/brep.h"

namespace sectile {

/// The vertices at whose place others lie, and those from which several edges lead to one place;
/// ascending. Vertices at one place have one point. Two edges at one place, where four faces meet
/// in a line, lie between two of them.
std::vector<VertexId> touching_vertices(const Brep& brep);

}  // namespace sectile
