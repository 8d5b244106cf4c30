// Pairs of triangles that certainly meet in nothing but the corners that they have in common, and
// did not on the way that rounding moved them: what doubles tell at once, as they do of nearly all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/four_points.h"
#include "numbers/sign.h"
#include "search/box.h"
#include "sectile/mesh.h"

namespace sectile {

/// Vertices with one number are one corner.
struct PlacedTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Vec3, 3> at;
};

/// With so much more on all sides.
Box box_around(const PlacedTriangle& triangle, double wider);

/// The plane of a triangle whose corners were up to `slack` away in each coordinate, as were all
/// points that it is asked about.
class PlaneWithSlack {
 public:
  PlaneWithSlack() = default;
  PlaneWithSlack(const Vec3& a, const Vec3& b, const Vec3& c, double slack);

  /// On which side d certainly always was: positive where the points turn left as seen from d. Zero
  /// if doubles do not tell.
  Sign clear_side(const Vec3& d) const {
    const double w[3] = {d.x - corner_.x, d.y - corner_.y, d.z - corner_.z};
    const double reach = std::max({std::abs(w[0]), std::abs(w[1]), std::abs(w[2])});
    const double value = w[0] * normal_[0] + w[1] * normal_[1] + w[2] * normal_[2];
    const double off = off_ + off_with_reach_ * reach;
    // Underflow of products is nothing beside numbers of that order.
    return reach < 0x1p200 && off > 0x1p-750 && std::abs(value) > off ? sign_of(value) : Sign::zero;
  }
  const std::array<double, 3>& normal() const { return normal_; }
  /// How far its coordinates may be off those of where the corners were, all together.
  double normal_off() const { return off_with_reach_; }

 private:
  Vec3 corner_;
  std::array<double, 3> normal_ = {};
  // How far the volume of the three points and a fourth may be off that of where they were, at the
  // most: the first, and the second times the reach of the fourth from the first.
  double off_ = 0, off_with_reach_ = 0;
};

/// From where a triangle always had an area, and which way its corners turn then.
struct TriangleView {
  int axis = -1;  ///< none if doubles see no area
  Sign turn = Sign::zero;
  bool clear() const { return axis >= 0; }
};

/// A triangle with what is asked of it many times.
struct ViewedTriangle {
  ViewedTriangle() = default;
  ViewedTriangle(const PlacedTriangle& triangle, double slack);

  PlacedTriangle placed;
  PlaneWithSlack plane;
  TriangleView view;
};

/// False if more than doubles is needed to tell. The view of s is clear. `slack`: that of both.
bool clearly_meet_in_corners(const ViewedTriangle& s, const ViewedTriangle& t, double slack);

}  // namespace sectile
