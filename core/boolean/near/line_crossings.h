// Where crowded lines cross each other.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/kernel.h"
#include "search/spine_lines.h"

namespace sectile {

struct LineCrossing {
  std::array<std::uint32_t, 2> line;
  Vec3 place;                 ///< rounded
  std::array<Vec3, 2> ahead;  ///< for each of the lines a point beside it, on the other one
};

/// Two planes that meet in a line; invalid if they are not known.
using PlanesOfLine = std::pair<PlaneId, PlaneId>;

/// Those between the ends of both lines, which are points of the kernel's geometry by their
/// numbers.
std::vector<LineCrossing> line_crossings(const Kernel& kernel, const SpineLines& lines,
                                         std::span<const PlanesOfLine> planes);

/// How a face at one of two lines leaves their crossing.
///
/// Faces at different lines that leave the plane of both lines to different sides, up and down,
/// meet in nothing but the crossing. Each of those that leave it to one side covers some directions
/// as seen along either line: what they have in common off the crossing is in directions that both
/// cover.
class LeavingCrossing {
 public:
  /// The face is at crossing.line[own].
  LeavingCrossing(const SpineLines& lines, const LineCrossing& crossing, unsigned own)
      : lines_(lines), crossing_(crossing), own_(own) {}

  void add_corner(const Vec3& place, const std::array<bool, 2>& is_on_line);
  /// Of faces at different lines that meet in more than the crossing, the boxes overlap: in the
  /// directions seen along both lines, and in the side.
  Box box() const;

 private:
  struct Range {
    double low = 1, high = -1;
    void add(double from, double to) {
      low = std::min(low, from);
      high = std::max(high, to);
    }
  };

  const SpineLines& lines_;
  const LineCrossing& crossing_;
  unsigned own_;
  std::array<Range, 2> turned_;
  Range side_;
};

}  // namespace sectile
