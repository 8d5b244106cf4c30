// Copies in a row, around an axis or along a path, and mirror images: where each copy stands.
#pragma once

#include <cstdint>
#include <vector>

#include "sectile/sectile.h"

namespace sectile::viewer {

/// What is repeated are the node's children together; all coordinates are the node's own.
struct Pattern {
  enum class Kind : std::uint8_t { linear, polar, path, mirror };
  Kind kind = Kind::linear;
  std::uint32_t count = 3;  ///< linear, polar, path: the first one is counted
  Vec3 step{3, 0, 0};       ///< linear: from one to the next
  Vec3 centre{0, 0, 0};     ///< polar: a point of the axis; mirror: of the plane
  Vec3 axis{0, 0, 1};       ///< polar: its direction; mirror: at right angles to the plane
  double degrees = 360;     ///< polar: a full turn is divided evenly, others reach from end to end
  std::vector<Vec3> path;   ///< path: its corners; the first copy stands at the first
  bool turns = true;        ///< path: copies turn with it
  bool keeps = true;        ///< mirror: the original stays
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

/// From the children's coordinates to those of the node, for each copy in turn. Rows whose step
/// doubles add exactly, right angles and mirrors across an axis are exact. Throws
/// std::invalid_argument, which says what is wrong.
std::vector<Transform> copies_of(const Pattern& pattern);

}  // namespace sectile::viewer
