// The convex hull of a face, for a quick test that two faces are apart.
#pragma once

#include <span>

#include "geometry/geometry.h"
#include "topology/brep.h"

namespace sectile {

class Hull {
 public:
  Hull() = default;
  /// Around points in one plane, at least three, in the order of a polygon, which are known up to
  /// half an ulp in each coordinate. Many points are replaced by a box around them.
  explicit Hull(std::span<const Vec3> points);

  /// Are two hulls certainly apart? Never true of hulls that have a point in common. Asked of hulls
  /// whose boxes are not apart.
  friend bool apart(const Hull& a, const Hull& b);

 private:
  struct Range {
    double low = 0, high = 0;
  };
  Range along(const Vec3& direction) const;
  bool separated_along(const Vec3& direction, const Range& mine, const Hull& other) const;
  bool separated_along(const Vec3& direction, const Hull& other) const {
    return separated_along(direction, along(direction), other);
  }
  bool separated_by_side(const Hull& other) const;
  bool has_corner_of(const Hull& other) const;

  static constexpr std::uint32_t few = 4;
  std::uint32_t edge_count() const { return count_ > few ? 3 : count_; }
  Vec3 edge(std::uint32_t i) const;

  Vec3 points_[8];  // of a polygon, or the corners of a box
  std::uint32_t count_ = 0;
  Vec3 reach_;  // the greatest size of each coordinate
  Vec3 normal_;
  Range along_normal_;
  bool along_axes_ = true;  // are all edges parallel to axes?
};

/// Around a face: its outer loop.
Hull face_hull(const Brep& brep, const Geometry& geometry, FaceId face);

}  // namespace sectile
