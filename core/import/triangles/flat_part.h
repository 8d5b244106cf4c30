// The triangles that are coplanar with neighbours: they are joined by the general means, as a
// part of the boundary beside the blocks of all others.
#pragma once

#include "import/triangles/triangle_mesh.h"
#include "topology/brep.h"

namespace sectile {

struct FlatPart {
  std::vector<std::uint32_t> triangles;  ///< ascending
  std::vector<std::uint8_t> holds;       ///< per triangle of the mesh
  Brep brep;                             ///< faces of kind `rest` stand for all other triangles
  Geometry geometry;
  /// Edge e < open.size() leaves the part: its even half-edge is that of the corner open[e].
  std::vector<std::uint32_t> open;
};

/// Without brep and geometry.
FlatPart find_flat_part(const TriangleMesh& mesh);

/// The brep and the geometry of a part whose triangles are known. Of chunks with any of these, the
/// mesh knows the mates from here on.
void build_flat_part(TriangleMesh& mesh, std::uint32_t origin, FlatPart& part);

}  // namespace sectile
