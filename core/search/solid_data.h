// What a Solid holds.
#pragma once

#include <memory>
#include <mutex>

#include "geometry/geometry.h"
#include "search/face_tree.h"
#include "topology/brep.h"

namespace sectile {

struct SolidData {
  Brep brep;
  Geometry geometry;
  std::uint32_t origin = 0;  ///< see Solid::origin

  /// The bounding volume hierarchy over the faces, built when first asked for and then kept.
  const FaceTree& tree() const;

 private:
  mutable std::once_flag tree_once_;
  mutable std::unique_ptr<FaceTree> tree_;
};

}  // namespace sectile
