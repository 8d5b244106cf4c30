// Half-planes around the z axis, in whole numbers: cross products tell all about them.
#pragma once

namespace sectile::test {

/// In which a half-plane leaves the axis.
struct Direction {
  int x, y;
};

/// Positive: the second one is less than half a turn counter-clockwise from the first one.
inline int cross(const Direction& a, const Direction& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace sectile::test
