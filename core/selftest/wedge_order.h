// Wedges of material around a line.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// The part of a face on one side of a line: the side on which the material's boundary lies to the
/// left, seen from outside, of one who goes forward along the line, or backward.
struct SideOfLine {
  PlaneId plane;
  bool forward;
  std::uint32_t number = 0;  ///< the caller's
};

/// Sorts what ends at a line counter-clockwise, seen by one to whom it comes forward, and says
/// whether the material alternates with the outside around it. If so, it lies between a backward
/// side and the forward one that follows. `axis` is one on which the line has an extent; forward is
/// the way up on it.
bool sort_around(const Kernel& kernel, int axis, std::span<SideOfLine> sides);

/// The same order, whatever alternates, as a number for each side: those that are one half-plane
/// have the same.
std::vector<std::uint32_t> places_around(const Kernel& kernel, int axis,
                                         std::span<const SideOfLine> sides);

}  // namespace sectile
