// The solid to cut off for a chamfer along an edge.
#pragma once

#include "scene/scene.h"
#include "scene/snapping.h"

namespace sectile::viewer {

/// An edge that goes outwards and how the faces beside it look, in the world.
struct ChamferEdge {
  Vec3 from, to;
  Vec3 first, second;  ///< the faces' normals: of length one, outwards
};

/// The edge of a solid with its two faces. Throws std::invalid_argument, which says why there can
/// be no chamfer: more than two faces, or an edge that goes inwards.
ChamferEdge chamfer_edge(const SnapTargets& solid, std::size_t edge);

/// A prism of the edge's length, with its own edge there and sides `size` wide on both faces.
struct ChamferCut {
  Primitive prism;
  Placement placement;
  bool is_exact = false;  ///< it meets edge and faces without rounding
};
ChamferCut chamfer_cut(const ChamferEdge& edge, double size);

}  // namespace sectile::viewer
