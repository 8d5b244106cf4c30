// The hierarchy over the faces of a solid.
#pragma once

#include <memory>

#include "geometry/geometry.h"
#include "parallel/once_alone.h"
#include "search/box_tree.h"
#include "search/four_faces.h"
#include "search/hubs.h"
#include "search/oriented_tree.h"
#include "topology/brep.h"

namespace sectile {

/// The box of the rounded positions. Rounding is monotonic, so boxes of faces that meet overlap.
Box face_box(const Brep& brep, const Geometry& geometry, FaceId face);

/// The groups of the tree are the hubs.
class FaceTree : public BoxTree {
 public:
  /// `along_curve`: are neighbours among the faces neighbours in space?
  FaceTree(const Brep& brep, const Geometry& geometry, bool along_curve)
      : FaceTree(brep, geometry, Hubs(brep), along_curve) {}
  const Hubs& hubs() const { return hubs_; }
  /// Oriented boxes for the faces of which this was made, if they are much smaller than the
  /// axis-parallel ones. Found when first asked for, and then kept.
  const OrientedTree* oriented(const Brep& brep, const Geometry& geometry) const;
  /// The same faces, those of each leaf side by side. Found when first asked for, and then kept.
  std::span<const FourFaces> fours(const Brep& brep, const Geometry& geometry) const;

 private:
  FaceTree(const Brep& brep, const Geometry& geometry, Hubs hubs, bool along_curve);
  Hubs hubs_;
  mutable OnceFlag oriented_once_, fours_once_;
  mutable std::unique_ptr<OrientedTree> oriented_;
  mutable std::vector<FourFaces> fours_;
};

}  // namespace sectile
