// Whether the triangles around a vertex certainly meet in nothing but their common corners: seen
// from some direction they lie side by side, once around it. Doubles tell that of nearly all
// vertices, and of all pairs of their triangles at once.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "rounding/clear_pairs.h"

namespace sectile {

/// From where the corners of a triangle turn left, wherever they were on their way.
class Facing {
 public:
  using Direction = std::array<double, 3>;

  /// No direction is certain.
  Facing() = default;
  explicit Facing(const PlaneWithSlack& plane);

  /// The normal in doubles, of length 1; zero if nothing is certain.
  const Direction& normal() const { return normal_; }
  /// Did they certainly always turn left as seen from there? `reach`: the largest coordinate.
  bool certainly(const Direction& from, double reach) const {
    return normal_[0] * from[0] + normal_[1] * from[1] + normal_[2] * from[2] > off_ * reach;
  }

 private:
  Direction normal_ = {};
  double off_ = std::numeric_limits<double>::infinity();
};

struct StarTriangle {
  Facing facing;
  Vec3 first, second;  ///< the corners that come after the vertex
};

/// False if more than doubles is needed to tell. The triangles are all that are at the vertex, in
/// any order: each edge at it leads into as many of them as out of them.
bool is_clear_star(const Vec3& vertex, std::span<const StarTriangle> triangles);

}  // namespace sectile
