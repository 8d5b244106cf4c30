// The half-edges of polygons by their lower end points.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "import/polygons.h"

namespace sectile {

/// A half-edge on the line between two points.
struct LineEntry {
  PointId high;
  std::uint32_t corner;
  bool forward;  ///< runs from the lower to the higher point
};

/// All half-edges, in one bucket for the lower end point of each.
class EdgeBuckets {
 public:
  explicit EdgeBuckets(const Polygons& polygons) {
    const std::size_t count = polygons.corners.size();
    std::uint32_t points = 0;
    for (const PointId p : polygons.corners) points = std::max(points, p.value() + 1);
    end_.assign(points + 1, 0);
    visit(polygons,
          [&](std::uint32_t, PointId a, PointId b) { ++end_[std::min(a, b).value() + 1]; });
    for (std::uint32_t p = 0; p < points; ++p) end_[p + 1] += end_[p];
    entries_.resize(count);
    std::vector<std::uint32_t> at(end_.begin(), end_.end() - 1);
    visit(polygons, [&](std::uint32_t corner, PointId a, PointId b) {
      entries_[at[std::min(a, b).value()]++] = {std::max(a, b), corner, a < b};
    });
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(end_.size() - 1); }
  std::span<LineEntry> operator[](std::uint32_t p) {
    return std::span(entries_).subspan(end_[p], end_[p + 1] - end_[p]);
  }

 private:
  template <class Visit>
  static void visit(const Polygons& polygons, const Visit& visit_edge) {
    for (std::uint32_t l = 0; l < polygons.loop_end.size(); ++l) {
      const std::uint32_t begin = polygons.loop_begin(l), end = polygons.loop_end[l];
      for (std::uint32_t i = begin; i < end; ++i)
        visit_edge(i, polygons.corners[i], polygons.corners[i + 1 < end ? i + 1 : begin]);
    }
  }

  std::vector<std::uint32_t> end_;
  std::vector<LineEntry> entries_;
};

}  // namespace sectile
