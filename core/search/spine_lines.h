// The lines on which spines (search/hubs.h) lie, and the hubs on these lines.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/along_line.h"
#include "search/hubs.h"

namespace sectile {

class SpineLines {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  SpineLines() = default;
  /// Spines between some of the points, by their numbers.
  SpineLines(const Kernel& kernel, std::span<const PointId> points,
             std::span<const Hubs::Spine> spines);

  /// The numbers of lines are below this.
  std::size_t count() const { return lines_.size(); }
  /// The line on which a point lies, one of several, or none.
  std::uint32_t of_point(std::size_t point) const {
    return of_point_.empty() ? none : of_point_[point];
  }
  const AlongLine& operator[](std::uint32_t line) const { return lines_[line]; }

 private:
  std::vector<std::uint32_t> of_point_;  // empty if there is no line
  std::vector<AlongLine> lines_;
};

}  // namespace sectile
