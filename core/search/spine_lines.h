// Lines along which very many edges run, and the points on these lines.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/along_line.h"
#include "search/edges_by_line.h"

namespace sectile {

class SpineLines {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  SpineLines() = default;
  /// Through edges between some of the points.
  SpineLines(const Kernel& kernel, std::span<const PointId> points,
             std::span<const PointPair> edges);

  std::size_t count() const { return lines_.size(); }
  /// A point, and a line on which it is, between the ends of the edges there.
  struct On {
    std::uint32_t point, line;
    friend auto operator<=>(const On&, const On&) = default;
  };
  /// Those of one point.
  std::span<const On> of_point(std::uint32_t point) const {
    const auto from = std::ranges::lower_bound(on_, point, {}, &On::point),
               to = std::ranges::upper_bound(on_, point, {}, &On::point);
    return {from, to};
  }
  /// The first line on which a point lies, or none.
  std::uint32_t first_of_point(std::uint32_t point) const {
    const auto lines = of_point(point);
    return lines.empty() ? none : lines.front().line;
  }
  /// The line on which most of some points lie, or none. for_each_point(visit) calls visit(point).
  template <class ForEachPoint>
  std::uint32_t line_of_most(const ForEachPoint& for_each_point) const {
    std::vector<std::uint32_t> lines;
    for_each_point([&](PointId p) {
      for (const On& on : of_point(p.value())) lines.push_back(on.line);
    });
    std::uint32_t best = none;
    std::ptrdiff_t most = 0;
    for (const std::uint32_t line : lines)
      if (const auto points = std::ranges::count(lines, line); points > most) {
        most = points;
        best = line;
      }
    return best;
  }
  /// All, ascending.
  std::span<const On> points() const { return on_; }
  const AlongLine& operator[](std::uint32_t line) const { return lines_[line]; }
  /// The points at both ends of the edges on a line.
  const PointPair& extent(std::uint32_t line) const { return extents_[line]; }

 private:
  std::vector<On> on_;
  std::vector<AlongLine> lines_;
  std::vector<PointPair> extents_;
};

}  // namespace sectile
