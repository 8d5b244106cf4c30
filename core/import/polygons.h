// The polygons of an input while they are made ready: corners are points, equal positions are one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "import/soup.h"

namespace sectile {

/// Faces as loops of points; the first loop of each is the outer one.
struct Polygons {
  std::vector<PointId> corners;
  std::vector<std::uint32_t> loop_end;  ///< per loop: end of its corners
  std::vector<std::uint32_t> face_end;  ///< per face: end of its loops
  std::vector<std::uint32_t> source;    ///< per face: the input's face

  std::size_t face_count() const { return face_end.size(); }
  std::uint32_t first_loop(std::size_t f) const { return f > 0 ? face_end[f - 1] : 0; }
  std::uint32_t loop_begin(std::size_t l) const { return l > 0 ? loop_end[l - 1] : 0; }
  std::span<const PointId> loop(std::size_t l) const {
    return std::span(corners).subspan(loop_begin(l), loop_end[l] - loop_begin(l));
  }
  void add_loop(std::span<const PointId> points) {
    corners.insert(corners.end(), points.begin(), points.end());
    loop_end.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  void end_face(std::uint32_t from) {
    face_end.push_back(static_cast<std::uint32_t>(loop_end.size()));
    source.push_back(from);
  }
};

/// Checks sizes, indices and coordinates, unites equal positions and drops repeated corners.
Polygons read_polygons(const Soup& soup, Geometry& geometry);

/// Removes faces without area; their neighbours across long edges take the points on these edges.
void remove_flat_faces(Polygons& polygons, const Kernel& kernel);

/// Finds the plane of each face (one plane for each, with the face's number); splits what is not
/// planar, or touches itself, into triangles.
void find_face_planes(Polygons& polygons, Geometry& geometry, Kernel& kernel);

/// For each corner: the corner whose half-edge is the other half of its edge (each corner stands
/// for the half-edge that leaves it). Lines with several edges are resolved into wedges of
/// material.
std::vector<std::uint32_t> match_edges(const Polygons& polygons, const Kernel& kernel);

/// Do three points lie on a line?
bool collinear(const Kernel& kernel, PointId a, PointId b, PointId c);

/// "(x, y, z)"
std::string in_words(const Vec3& p);

}  // namespace sectile
