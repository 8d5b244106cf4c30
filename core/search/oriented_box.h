// Boxes that lie as the things lie that they hold.
#pragma once

#include <span>

#include "search/box.h"

namespace sectile {

/// The points centre + Σ aᵢ·extentᵢ·axisᵢ + s with aᵢ in [-1, 1] and components of s up to `slack`.
/// However the axes were rounded, that holds the points the box was made of: what they leave of a
/// point, and all errors of tests, are in the slack.
struct OrientedBox {
  Vec3 centre;
  Vec3 axis[3];  ///< about unit vectors at right angles
  double extent[3] = {0, 0, 0};
  double slack = 0;

  OrientedBox() = default;
  /// Around points, at least one, that are known up to half an ulp in each coordinate. The first
  /// axis lies along them, the last one across a polygon.
  explicit OrientedBox(std::span<const Vec3> points);
  /// Around an axis-parallel box that is not empty.
  explicit OrientedBox(const Box& box);
};

/// Are two boxes certainly apart? Never true of boxes that have a point in common.
bool apart(const OrientedBox& a, const OrientedBox& b);

/// Where a line along the x axis, which starts at a place, comes into a box, about: its x.
double begin_along_x(const OrientedBox& box, const Vec3& start);

/// Do boxes cover each other many times over, as those of long things do that lie aslant, so that
/// oriented ones are worth their while?
bool are_mostly_empty(std::span<const Box> boxes);

}  // namespace sectile
