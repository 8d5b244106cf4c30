// Wedges of material around a line.
#pragma once

#include <array>

#include "geometry/kernel.h"

namespace sectile {

/// The part of a face on one side of a line: the side on which the material's boundary lies to the
/// left, seen from outside, of one who goes forward along the line, or backward.
struct SideOfLine {
  PlaneId plane;
  bool forward;
};

/// Does the material alternate with the outside around a line on which four faces end? `axis` is
/// one on which the line has an extent; forward is the way up on it.
bool material_alternates(const Kernel& kernel, int axis, std::array<SideOfLine, 4> sides);

}  // namespace sectile
