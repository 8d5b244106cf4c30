// The edges of a mesh whose half-edges do not add up to a closed surface.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::viewer {

struct OddEdge {
  Vec3 from, to;
  std::uint32_t piece = 0;  ///< edges that hang together have the same number
};

struct OddEdges {
  std::vector<OddEdge> borders;         ///< an odd number of faces
  std::vector<OddEdge> contradictions;  ///< an even number, but not as many one way as the other
};

/// Do sizes, indices and coordinates make a mesh that can be drawn?
bool can_be_drawn(const PolygonMesh& mesh);

/// Equal positions are one point. Only of a mesh that can be drawn.
OddEdges odd_edges(const PolygonMesh& mesh);

}  // namespace sectile::viewer
