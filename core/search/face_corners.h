// The corners of a face as places.
#pragma once

#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "topology/brep.h"

namespace sectile {

/// Calls visit(span of Vec3) with the rounded positions along the outer loop.
template <class Visit>
auto with_outer_corners(const Brep& brep, const Geometry& geometry, FaceId face,
                        const Visit& visit) {
  constexpr std::size_t most_of_few = 4;
  Vec3 few[most_of_few];
  std::vector<Vec3> many;
  std::size_t count = 0;
  for_each_in_loop(brep, brep.outer_loop[face], [&](HalfEdgeId h) {
    const Vec3& p = geometry.position(brep.point_of(brep.from(h)));
    if (count == most_of_few) many.assign(few, few + most_of_few);
    if (count < most_of_few)
      few[count] = p;
    else
      many.push_back(p);
    ++count;
  });
  return visit(count <= most_of_few ? std::span<const Vec3>(few, count)
                                    : std::span<const Vec3>(many));
}

/// Calls add(PointId) for the corners of a face, loop after loop; returns where the loops end.
template <class Add>
std::vector<std::uint32_t> collect_corners(const Brep& brep, FaceId face, const Add& add) {
  std::vector<std::uint32_t> loop_ends;
  std::uint32_t count = 0;
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l]) {
    for_each_in_loop(brep, l, [&](HalfEdgeId h) {
      add(brep.point_of(brep.from(h)));
      ++count;
    });
    loop_ends.push_back(count);
  }
  return loop_ends;
}

}  // namespace sectile
