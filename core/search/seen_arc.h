// What of all directions a plane face covers, as seen from a point: an arc of a great circle, if it
// has the point at its border, and nearly one if it is thin.
//
//        .---.         Plane faces that have a point in common, corner or edge, meet elsewhere only
//      /  \    \       if they are seen in a common direction from there, that is, if their arcs
//     |    \    |      meet. Boxes around the directions say little where arcs are long and aslant.
//      \    \  /
//        '---'
#pragma once

#include <array>
#include <span>

#include "sectile/mesh.h"

namespace sectile {

/// Half a turn at most. Where that, or too much, is not clear in doubles, it is not known.
class SeenArc {
 public:
  /// Covers all directions.
  SeenArc() = default;
  /// From a point that is a corner of a face, or not on it at all, of which the (other) corners are
  /// given as far as they span it. All are known up to half an ulp in each coordinate.
  static SeenArc from_point(const Vec3& point, std::span<const Vec3> corners);
  /// The same from a point that is, exactly, on an edge of the face, and not at its ends, of which
  /// one is given, beside the corners that are no ends: half a turn.
  static SeenArc from_edge(const Vec3& point, const Vec3& end, std::span<const Vec3> others);

  bool is_known() const { return count_ > 0; }
  /// Unit vectors, each turned by a right angle at most against the one before.
  std::span<const Vec3> way() const { return std::span(way_).first(count_); }
  /// Each direction seen is a sum of two vectors that follow each other on the way, with weights of
  /// at least zero, but for a vector that is no longer than the sum of their radii with the same
  /// weights. So an arc may be pointed.
  double radius(std::size_t vector) const { return radius_[vector]; }

 private:
  static SeenArc between(const Vec3& first, const Vec3& last);
  bool is_thin() const;

  std::array<Vec3, 3> way_;
  std::size_t count_ = 0;
  std::array<double, 3> radius_{};
};

}  // namespace sectile
