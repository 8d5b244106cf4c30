// From faces whose half-edges are paired to the half-edge structure.
#pragma once

#include <vector>

#include "import/polygons.h"
#include "topology/brep.h"

namespace sectile {

/// Each corner stands for the half-edge that leaves it; `mate` pairs them. Vertices are what the
/// cycles of edges say. The faces' planes and sources are left to the caller.
void build_brep(const Polygons& polygons, const std::vector<std::uint32_t>& mate, Brep& brep);

}  // namespace sectile
