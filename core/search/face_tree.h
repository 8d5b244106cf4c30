// The hierarchy over the faces of a solid.
#pragma once

#include "geometry/geometry.h"
#include "search/box_tree.h"
#include "topology/brep.h"

namespace sectile {

/// The box of the rounded positions. Rounding is monotonic, so boxes of faces that meet overlap.
Box face_box(const Brep& brep, const Geometry& geometry, FaceId face);

class FaceTree : public BoxTree {
 public:
  FaceTree(const Brep& brep, const Geometry& geometry);
};

}  // namespace sectile
