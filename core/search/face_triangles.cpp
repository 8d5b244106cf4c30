#include "search/face_triangles.h"

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"

namespace sectile {

std::vector<std::array<Vec3, 3>> face_triangles(const Brep& brep, const Kernel& kernel,
                                                FaceId face) {
  std::vector<PointId> corners;
  std::vector<std::uint32_t> loop_ends;
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l]) {
    for_each_in_loop(brep, l,
                     [&](HalfEdgeId h) { corners.push_back(brep.point_of(brep.from(h))); });
    loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  const PlaneId plane = brep.plane[face];
  const int axis = kernel.main_axis(plane);
  const FacePredicates exact(kernel, axis, kernel.normal(plane, axis) == Sign::negative, corners);
  std::vector<std::array<std::uint32_t, 3>> numbers;
  triangulate(exact, std::span<const std::uint32_t>(loop_ends), numbers);
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(numbers.size());
  const auto at = [&](std::uint32_t i) { return kernel.geometry().position(corners[i]); };
  for (const auto& [i, j, k] : numbers) triangles.push_back({at(i), at(j), at(k)});
  return triangles;
}

}  // namespace sectile
