// Edges that are on one line, whatever their ends are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// Two points, by their numbers, ascending.
struct PointPair {
  std::uint32_t from, to;
  friend auto operator<=>(const PointPair&, const PointPair&) = default;
  static PointPair between(std::uint32_t p, std::uint32_t q) {
    return {std::min(p, q), std::max(p, q)};
  }
};

/// Edges between some of the points that are on one line.
struct EdgesOfLine {
  std::vector<PointPair> edges;
  PointPair extent;        ///< from end to end of what they cover
  std::size_t beside = 0;  ///< pairs of edges of which both cover some stretch
};

/// By lines. An edge for which doubles do not tell well on which line it is may be missing: one
/// that is very short beside all of them together.
std::vector<EdgesOfLine> edges_by_line(const Kernel& kernel, std::span<const PointId> points,
                                       std::span<const PointPair> edges);

/// From end to end, the lines whose edges run beside so many others, or more, on the average.
std::vector<PointPair> crowded_lines(const Kernel& kernel, std::span<const PointId> points,
                                     std::span<const PointPair> edges, std::size_t others);

/// Are three points on one line?
bool are_on_one_line(const Kernel& kernel, PointId p, PointId q, PointId r);
/// Is a point on an edge, and not at its ends?
bool is_within_edge(const Kernel& kernel, PointId p, PointId from, PointId to);

}  // namespace sectile
