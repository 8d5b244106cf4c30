#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "import/polygons.h"
#include "sectile/triangulation.h"

namespace sectile {
namespace {

void check(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends) {
  std::uint32_t begin = 0;
  for (const std::uint32_t end : loop_ends) {
    if (end <= begin || end > corners.size())
      throw std::invalid_argument("triangulate: a loop without corners");
    begin = end;
  }
  if (loop_ends.empty() || begin != corners.size())
    throw std::invalid_argument("triangulate: corners that no loop has");
  const bool finite = std::all_of(corners.begin(), corners.end(), [](const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
  if (!finite) throw std::invalid_argument("triangulate: coordinates that are not finite");
}

}  // namespace

std::vector<CornerTriangle> triangulate(std::span<const Vec3> corners,
                                        std::span<const std::uint32_t> loop_ends) {
  check(corners, loop_ends);
  if (corners.size() == 3 && loop_ends.size() == 1) return {{0, 1, 2}};
  // Each corner is a point of its own, so that a point's number is its corner's.
  Geometry geometry;
  Polygons polygon;
  for (const Vec3& corner : corners) polygon.corners.push_back(geometry.add_point(corner));
  polygon.loop_end.assign(loop_ends.begin(), loop_ends.end());
  polygon.end_face(0);
  const Kernel kernel(geometry);
  Polygons made;
  split_face(kernel, polygon, 0, false, CrossingFaces::split, made);
  std::vector<CornerTriangle> triangles;
  triangles.reserve(made.face_count());
  for (std::size_t i = 0; i < made.corners.size(); i += 3)
    triangles.push_back(
        {made.corners[i].value(), made.corners[i + 1].value(), made.corners[i + 2].value()});
  return triangles;
}

}  // namespace sectile
