// Pairs of triangles that certainly meet in nothing but the corners that they have in common, and
// did not on the way that rounding moved them: what doubles tell at once, as they do of nearly all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/four_points.h"
#include "numbers/sign.h"
#include "sectile/mesh.h"

namespace sectile {

/// Vertices with one number are one corner.
struct PlacedTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Vec3, 3> at;
};

/// Of two points, in the coordinate in which it is the largest.
inline double largest_difference(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(b.z - a.z)});
}

/// Side by side, as one instruction is for two numbers: an extension that GCC and Clang have in
/// common.
struct ThreePoints {
  using Two = double __attribute__((vector_size(16)));

  ThreePoints() = default;
  explicit ThreePoints(const std::array<Vec3, 3>& p)
      : first_two{Two{p[0].x, p[1].x}, Two{p[0].y, p[1].y}, Two{p[0].z, p[1].z}},
        last{Two{p[2].x, p[2].x}, Two{p[2].y, p[2].y}, Two{p[2].z, p[2].z}} {}

  std::array<Two, 3> first_two = {}, last = {};  ///< per coordinate
};

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

  /// Which of three points certainly always were on its two sides: a bit for each.
  struct Sides {
    unsigned above, below;
  };
  /// In no coordinate they are farther than `reach` from the first point of the plane.
  Sides clear_sides(const ThreePoints& points, double reach) const {
    const double off = off_ + off_with_reach_ * reach;
    if (!(reach < 0x1p200 && off > 0x1p-750)) return {0, 0};
    const ThreePoints::Two first = value(points.first_two), last = value(points.last);
    const auto bits = ((first > off) & Bits{1, 2}) | ((last > off) & Bits{4, 0}) |
                      ((first < -off) & Bits{8, 16}) | ((last < -off) & Bits{32, 0});
    const auto all = static_cast<unsigned>(bits[0] | bits[1]);
    return {all & 7u, all >> 3};
  }

 private:
  using Bits = std::int64_t __attribute__((vector_size(16)));
  ThreePoints::Two value(const std::array<ThreePoints::Two, 3>& points) const {
    return (points[0] - corner_.x) * normal_[0] + (points[1] - corner_.y) * normal_[1] +
           (points[2] - corner_.z) * normal_[2];
  }

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
  ThreePoints points;
  PlaneWithSlack plane;
  TriangleView view;
  /// No coordinate of a corner is farther from that of the first. Infinite if two are one vertex.
  double extent = 0;
};

/// Are the corners of t, but those of s, clearly on one side of the plane of s? None of them is
/// farther than `reach` from the first corner of s.
inline bool beside_plane(const ViewedTriangle& s, const ViewedTriangle& t, double reach) {
  const auto [above, below] = s.plane.clear_sides(t.points, reach);
  if ((above != 0) == (below != 0)) return false;
  const unsigned clear = above | below;
  if (clear == 7) return true;
  const auto& own = s.placed.vertex;
  for (unsigned i = 0; i < 3; ++i) {
    const std::uint32_t v = t.placed.vertex[i];
    if ((clear >> i & 1) == 0 && v != own[0] && v != own[1] && v != own[2]) return false;
  }
  return true;
}

/// What clearly_meet_in_corners() does where neither lies beside the plane of the other.
bool meet_in_corners_at_crossing_planes(const ViewedTriangle& s, const ViewedTriangle& t,
                                        double slack);

/// False if more than doubles is needed to tell. The view of s is clear. `slack`: that of both.
inline bool clearly_meet_in_corners(const ViewedTriangle& s, const ViewedTriangle& t,
                                    double slack) {
  const double apart = largest_difference(s.placed.at[0], t.placed.at[0]);
  return beside_plane(s, t, (1 + 0x1p-40) * (apart + t.extent)) ||
         beside_plane(t, s, (1 + 0x1p-40) * (apart + s.extent)) ||
         meet_in_corners_at_crossing_planes(s, t, slack);
}

}  // namespace sectile
