// A large mesh of triangles on its straight way into blocks.
//
// Most large meshes are closed surfaces without anything to be resolved: two triangles at each
// edge, one cycle of them around each point, volume within each shell. Their blocks are made
// straight from the mesh, block by block and in parallel; there never is one structure of all
// triangles. Whatever else a mesh is, the general way (import.cpp) takes it and says what is wrong
// with it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/geometry.h"
#include "storage/cut_into_blocks.h"

namespace sectile {

/// The triangles stand along a curve that fills space; so many that follow each other are a chunk,
/// of which a block is made. Triangle t has the corners 3t, 3t + 1 and 3t + 2; each corner stands
/// for the half-edge that leaves it.
struct TriangleMesh {
  std::shared_ptr<Geometry> geometry;  ///< the points of the input; shells of one mesh share them
  std::vector<PointId> corners;
  std::vector<std::uint32_t> source;  ///< per triangle: the face of the input
  /// Per corner: the one whose half-edge runs the other way between the same points.
  std::vector<std::uint32_t> mate;

  /// Per corner: the number of its point within its chunk, in the order in which points are met.
  std::vector<std::uint16_t> vertex;
  std::vector<std::uint16_t> vertex_count;  ///< per chunk
  /// Per chunk: do its triangles hang together over its edges? Empty if nobody has looked.
  std::vector<std::uint8_t> hangs_together;

  /// The first triangle of each chunk, and the end.
  std::vector<std::uint32_t> chunk_begins;
  static constexpr std::uint32_t most_of_a_chunk = faces_of_a_block + 2 * few_faces;

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(source.size()); }
  std::uint32_t chunk_count() const { return static_cast<std::uint32_t>(chunk_begins.size() - 1); }
  std::uint32_t chunk_begin(std::uint32_t c) const { return chunk_begins[c]; }
  std::uint32_t chunk_end(std::uint32_t c) const { return chunk_begins[c + 1]; }
  bool is_in_chunk(std::uint32_t corner, std::uint32_t c) const {
    return chunk_begin(c) <= corner / 3 && corner / 3 < chunk_end(c);
  }
  std::uint32_t chunk_of(std::uint32_t corner) const {
    std::uint32_t c = near_chunk[corner / 3 / near_triangles];
    while (corner / 3 >= chunk_end(c)) ++c;
    return c;
  }
  /// Per so many triangles: the chunk of the first one.
  static constexpr std::uint32_t near_triangles = 64;
  std::vector<std::uint32_t> near_chunk;
  /// After chunk_begins was set.
  void index_chunks() {
    for (std::uint32_t c = 0; c < chunk_count(); ++c)
      near_chunk.resize((chunk_end(c) + near_triangles - 1) / near_triangles, c);
  }

  static std::uint32_t next(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  static std::uint32_t prev(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  PointId from(std::uint32_t corner) const { return corners[corner]; }
  PointId to(std::uint32_t corner) const { return corners[next(corner)]; }
  const Vec3& position(std::uint32_t corner) const { return geometry->position(corners[corner]); }
};

}  // namespace sectile
