// Pairs of triangles that certainly meet in nothing but the corners that they have in common: what
// doubles tell at once, as they do of nearly all.
#pragma once

#include <array>
#include <cstdint>

#include "numbers/sign.h"
#include "sectile/mesh.h"

namespace sectile {

/// Vertices with one number are one corner; their places are exact.
struct PlacedTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Vec3, 3> at;
};

/// From where a triangle has an area, and which way its corners turn then.
struct TriangleView {
  int axis = -1;  ///< none if doubles see no area
  Sign turn = Sign::zero;
  bool clear() const { return axis >= 0; }
};

TriangleView clear_view(const PlacedTriangle& triangle);

/// False if more than doubles is needed to tell. `view`: that of s, which is clear.
bool clearly_meet_in_corners(const PlacedTriangle& s, const TriangleView& view,
                             const PlacedTriangle& t);

}  // namespace sectile
