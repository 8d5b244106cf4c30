// What of all directions a plane face covers, as seen from a point of it: an arc of a great circle.
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

/// Less than half a turn. Where that, or too much, is not clear in doubles, it is not known.
class SeenArc {
 public:
  /// Covers all directions.
  SeenArc() = default;
  /// From a corner of a face, of which the other corners are given as far as they span it. All are
  /// known up to half an ulp in each coordinate.
  static SeenArc from_corner(const Vec3& corner, std::span<const Vec3> others);

  bool is_known() const { return count_ > 0; }
  /// Unit vectors, each turned by a right angle at most against the one before.
  std::span<const Vec3> way() const { return std::span(way_).first(count_); }
  /// All directions seen are so near to those between two of the way, as unit vectors.
  double error() const { return error_; }

 private:
  static SeenArc between(const Vec3& first, const Vec3& last);
  double distance(const Vec3& direction) const;

  std::array<Vec3, 3> way_;
  std::size_t count_ = 0;
  double error_ = 0;
};

}  // namespace sectile
