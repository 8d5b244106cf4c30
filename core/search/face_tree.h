// The hierarchy over the faces of a solid.
#pragma once

#include "geometry/geometry.h"
#include "search/box_tree.h"
#include "search/hubs.h"
#include "topology/brep.h"

namespace sectile {

/// The box of the rounded positions. Rounding is monotonic, so boxes of faces that meet overlap.
Box face_box(const Brep& brep, const Geometry& geometry, FaceId face);

/// The groups of the tree are the hubs.
class FaceTree : public BoxTree {
 public:
  FaceTree(const Brep& brep, const Geometry& geometry) : FaceTree(brep, geometry, Hubs(brep)) {}
  const Hubs& hubs() const { return hubs_; }

 private:
  FaceTree(const Brep& brep, const Geometry& geometry, Hubs hubs);
  Hubs hubs_;
};

}  // namespace sectile
