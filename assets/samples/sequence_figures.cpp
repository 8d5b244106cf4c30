#include "samples/lists.h"
#include "samples/shapes.h"

namespace sectile::samples {

namespace {

PolygonMesh corner_at_origin() {
  return block({0, 0, -8}, {8, 8, 0});
}

// The pyramid around A's edge along x crosses two of the sectors of A's corner.
Sample two_intersections() {
  return pair_sample("fig21", "Two coincident vertices, two sectors crossed", "21",
                     Operation::subtract, corner_at_origin(),
                     cone({0, 0, 0}, {{4, -2, -2}, {4, 2, -2}, {4, 2, 2}, {4, -2, 2}}));
}

// A cone over an arch, in the plane x + y = 8: its two legs go through A's top, which is one
// sector, and cross it four times.
Sample several_intersections_in_one_sector() {
  std::vector<Vec3> arch;
  for (const Corner& c :
       std::vector<Corner>{{-3, -2}, {-1, -2}, {-1, 1}, {1, 1}, {1, -2}, {3, -2}, {3, 2}, {-3, 2}})
    arch.push_back({4 - c.u, 4 + c.u, c.v});
  return pair_sample("fig22", "Several intersections in one sector", "22", Operation::unite,
                     corner_at_origin(), cone({0, 0, 0}, arch));
}

// E1, an edge of the tetrahedron B, passes A's upper right edge E2 at a distance of
// depth / sqrt(2).
Sample close_edges(const char* name, const char* title, double depth) {
  const Vec3 above{2, 2, 6 - depth}, beside{6 - depth, 2, 2};
  return pair_sample(name, title, "23", Operation::unite, block({0, 0, 0}, {4, 4, 4}),
                     cone({6, 4, 6}, {above, beside, {6, 0, 6}}));
}

}  // namespace

std::vector<Sample> sequence_figures() {
  return {two_intersections(), several_intersections_in_one_sector(),
          close_edges("fig23", "An edge one bit beside an edge", 0x1p-50),
          close_edges("fig23-touching", "An edge exactly on an edge", 0)};
}

}  // namespace sectile::samples
