// What the faces leave on each other: segments in which two faces meet, and points.
#pragma once

#include <vector>

#include "arrangement/face_locator.h"
#include "arrangement/pairs.h"

namespace sectile::arrangement {

/// A segment within a face, in which it meets another one.
struct Trace {
  PointId from, to;
  PlaneId across;  ///< the other face's plane
};

/// Per face: the segments in which faces of other planes meet it, and all points in which corners
/// and edges of others, or its own, meet another face.
struct Traces {
  std::vector<std::uint32_t> trace_end, point_end;
  std::vector<Trace> traces;
  std::vector<PointId> points;

  std::span<const Trace> of(std::size_t f) const {
    const std::uint32_t begin = f > 0 ? trace_end[f - 1] : 0;
    return std::span(traces).subspan(begin, trace_end[f] - begin);
  }
  std::span<const PointId> points_of(std::size_t f) const {
    const std::uint32_t begin = f > 0 ? point_end[f - 1] : 0;
    return std::span(points).subspan(begin, point_end[f] - begin);
  }
};

/// Adds the points to the geometry. `first_at` is brought up to date: see unite_places.
Traces find_traces(const Facets& facets, const Pairs& pairs,
                   const std::vector<std::uint8_t>& convex, const EdgeLines& lines,
                   const std::vector<std::uint8_t>& wanted, Geometry& geometry, Kernel& kernel,
                   std::vector<PointId>& first_at, const Steering& steering);

/// Adds a point for each construction, in their order.
std::vector<PointId> add_points(const std::vector<Construction>& constructions, Geometry& geometry,
                                Kernel& kernel);

}  // namespace sectile::arrangement
