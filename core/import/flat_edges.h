// Steps of an import that a repair takes, too.
#pragma once

#include <cstdint>

#include "geometry/kernel.h"
#include "import/polygons.h"
#include "topology/brep.h"

namespace sectile {

/// Each face has a plane of its own, with its number.
void set_planes_and_sources(const Polygons& polygons, std::uint32_t origin, Brep& brep);

/// Edges between coplanar faces get a plane that pins them down. Throws InvalidSolid where such
/// faces are folded onto each other.
void pin_flat_edges(Brep& brep, Geometry& geometry, const Kernel& kernel);

/// For each corner the one whose half-edge runs the other way between the same two points; nothing
/// if anywhere there are more or fewer than two, or both run the same way.
std::vector<std::uint32_t> match_plain_edges(const Polygons& polygons, const Kernel& kernel);

}  // namespace sectile
