// The polygons of an input while they are made ready: corners are points, equal positions are one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "import/soup.h"

namespace sectile {

/// A soup or a mesh, wherever it is stored.
struct SoupView {
  std::span<const Vec3> positions;
  std::span<const std::uint32_t> face_loops;  ///< empty: each face has one loop
  std::span<const std::uint32_t> loop_sizes;
  std::span<const std::uint32_t> indices;

  std::size_t face_count() const {
    return face_loops.empty() ? loop_sizes.size() : face_loops.size();
  }
  std::uint32_t loops_of(std::size_t f) const { return face_loops.empty() ? 1 : face_loops[f]; }
};

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
  std::span<const PointId> face_corners(std::size_t f) const {
    const std::uint32_t begin = loop_begin(first_loop(f));
    return std::span(corners).subspan(begin, loop_end[face_end[f] - 1] - begin);
  }
  bool is_triangle(std::size_t f) const {
    const std::uint32_t l = first_loop(f);
    return face_end[f] == l + 1 && loop_end[l] - loop_begin(l) == 3;
  }

  void add_loop(std::span<const PointId> points) {
    corners.insert(corners.end(), points.begin(), points.end());
    loop_end.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  void end_face(std::uint32_t from) {
    face_end.push_back(static_cast<std::uint32_t>(loop_end.size()));
    source.push_back(from);
  }
  void add_triangle(PointId a, PointId b, PointId c, std::uint32_t from) {
    const PointId points[] = {a, b, c};
    add_loop(points);
    end_face(from);
  }
  /// A face of another list, as it is.
  void add_face(const Polygons& other, std::size_t f) {
    for (std::uint32_t l = other.first_loop(f); l < other.face_end[f]; ++l) add_loop(other.loop(l));
    end_face(other.source[f]);
  }
};

/// Throws InvalidSolid if sizes or indices do not fit, or coordinates are not finite.
void check_soup(const SoupView& soup);

/// Checks the soup, unites equal positions, drops repeated corners and paths
/// there and back again. `input_vertex` becomes each point's first position in the input.
Polygons read_polygons(const SoupView& soup, Geometry& geometry,
                       std::vector<std::uint32_t>& input_vertex);

/// Cuts off corners of 0°, and with them all faces without area; the neighbours across long edges
/// take the points on these edges.
void remove_flat_faces(Polygons& polygons, const Kernel& kernel);

/// What becomes of plane faces of one loop whose edges cross each other: they are refused, or split
/// into triangles, which overlap.
enum class CrossingFaces { refuse, split };

/// Finds the plane of each face (one plane for each, with the face's number); splits what is not
/// planar, or touches itself, into triangles.
void find_face_planes(Polygons& polygons, Geometry& geometry, Kernel& kernel,
                      CrossingFaces crossing = CrossingFaces::refuse);

/// Appends the triangles of a face that is to be split. They bound what the face bounds, whatever
/// it looks like; some may have no area.
void split_face(const Kernel& kernel, const Polygons& polygons, std::size_t face, bool planar,
                CrossingFaces crossing, Polygons& result);

/// Divides edges without a face on their other side at the ends of other such edges that lie on
/// them. Returns whether there are any.
bool divide_open_edges(Polygons& polygons, const Kernel& kernel,
                       std::span<const std::uint32_t> open_corners);

/// For each corner: the corner whose half-edge is the other half of its edge (each corner stands
/// for the half-edge that leaves it). Lines with several edges are resolved into wedges of
/// material. Faces get corners where their neighbours have some on a common edge.
std::vector<std::uint32_t> match_edges(Polygons& polygons, const Kernel& kernel,
                                       const std::vector<std::uint32_t>& input_vertex);

}  // namespace sectile
