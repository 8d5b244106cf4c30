// A large mesh of triangles on its straight way into blocks.
//
// Most large meshes are closed surfaces of one shell without anything to be resolved: two triangles
// at each edge, one cycle of them around each point, volume within. Their blocks are made straight
// from the mesh, block by block and in parallel; there never is one structure of all triangles.
// Whatever else a mesh is, the general way (import.cpp) takes it and says what is wrong with it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "storage/cut_into_blocks.h"

namespace sectile {

/// The triangles stand along a curve that fills space; so many that follow each other are a chunk,
/// of which a block is made. Triangle t has the corners 3t, 3t + 1 and 3t + 2; each corner stands
/// for the half-edge that leaves it.
struct TriangleMesh {
  Geometry geometry;
  std::vector<PointId> corners;
  std::vector<std::uint32_t> source;  ///< per triangle: the face of the input
  /// Per corner: the one whose half-edge runs the other way between the same points.
  std::vector<std::uint32_t> mate;

  static constexpr std::uint32_t of_a_chunk = faces_of_a_block;

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(source.size()); }
  std::uint32_t chunk_count() const { return (triangle_count() + of_a_chunk - 1) / of_a_chunk; }
  std::uint32_t chunk_begin(std::uint32_t c) const { return c * of_a_chunk; }
  std::uint32_t chunk_end(std::uint32_t c) const {
    return std::min((c + 1) * of_a_chunk, triangle_count());
  }
  static std::uint32_t chunk_of(std::uint32_t corner) { return corner / (3 * of_a_chunk); }

  static std::uint32_t next(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  static std::uint32_t prev(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  PointId from(std::uint32_t corner) const { return corners[corner]; }
  PointId to(std::uint32_t corner) const { return corners[next(corner)]; }
  const Vec3& position(std::uint32_t corner) const { return geometry.position(corners[corner]); }
};

}  // namespace sectile
