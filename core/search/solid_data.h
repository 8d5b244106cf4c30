// What a Solid holds.
#pragma once

#include <memory>
#include <mutex>

#include "geometry/geometry.h"
#include "search/face_tree.h"
#include "topology/brep.h"

namespace sectile {

class SolidData {
 public:
  std::uint32_t origin = 0;  ///< see Solid::origin

  const Brep& brep() const { return brep_; }
  const Geometry& geometry() const { return geometry_; }
  /// For who makes the solid, before it is shared.
  Brep& brep() { return brep_; }
  Geometry& geometry() { return geometry_; }

  /// The bounding volume hierarchy over the faces, built when first asked for and then kept.
  const FaceTree& tree() const;

  /// Are several of its vertices at one point? Found out when first asked.
  bool touches_itself() const;

  /// What make() gives when this is called first, and then kept: the same boundary with its edges
  /// paired for the complement (boolean/complement.h).
  template <class Make>
  const SolidData& complement(const Make& make) const {
    std::call_once(complement_once_, [&] { complement_ = make(); });
    return *complement_;
  }

 private:
  Brep brep_;
  Geometry geometry_;
  mutable std::once_flag tree_once_;
  mutable std::unique_ptr<FaceTree> tree_;
  mutable std::once_flag touches_once_;
  mutable bool touches_itself_ = false;
  mutable std::once_flag complement_once_;
  mutable std::shared_ptr<const SolidData> complement_;
};

}  // namespace sectile
