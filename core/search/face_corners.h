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

}  // namespace sectile
