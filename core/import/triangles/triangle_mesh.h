// A large mesh of triangles on its straight way into blocks.
//
// Most large meshes are closed surfaces without anything to be resolved: two triangles at each
// edge, one cycle of them around each point, volume within each shell. Their blocks are made
// straight from the mesh, block by block and in parallel; there never is one structure of all
// triangles. Whatever else a mesh is, the general way (import.cpp) takes it and says what is wrong
// with it.
//
// The triangles stand along a curve that fills space; so many that follow each other are a chunk,
// of which a block is made. All that can be found out about a chunk alone is found in one go, in
// memory that stays in the fastest cache. What is left are the edges and points between chunks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "import/volume_sum.h"
#include "numbers/id.h"
#include "numbers/unset_vector.h"
#include "storage/compact_triangles.h"
#include "storage/cut_into_blocks.h"

namespace sectile {

/// An edge that leads out of a chunk, seen from there. Numbers of points are those of the mesh.
struct ChunkBorder {
  std::uint32_t from, to, apex;  ///< the corners of its triangle
  std::uint16_t corner;          ///< of the chunk: the one that it leaves
  /// The border that comes next around `from`, clockwise: it ends the triangles of the chunk there.
  std::uint16_t around;
};

/// The line between two points.
inline std::uint64_t line_between(std::uint32_t p, std::uint32_t q) {
  return std::uint64_t(std::min(p, q)) << 32 | std::max(p, q);
}

/// What is known of a chunk.
struct TriangleChunk {
  CompactTriangles triangles;        ///< the block, if all of them are to be in one
  std::vector<ChunkBorder> borders;  ///< as they are numbered in the block
  /// The lines of all other edges between points that may be in other chunks, too.
  std::vector<std::uint64_t> chords;
  /// Those in one plane with a neighbour in the chunk, counted within it, maybe several times.
  std::vector<std::uint32_t> flat;
  std::uint32_t points_within = 0;  ///< around which all triangles are in the chunk
  VolumeSum volume;
};

/// The borders of all chunks, one chunk after the other.
struct ChunkBorders {
  struct Place {
    std::uint32_t chunk, number;
  };
  std::vector<std::uint32_t> begin;  ///< per chunk: its first one; and the end
  UnsetVector<ChunkBorder> all;
  UnsetVector<Place> own,
      beyond;  ///< where it is; where the same edge is, seen from the other side
  std::vector<std::uint32_t> flat;  ///< triangles in one plane with a neighbour in another chunk

  std::uint32_t count() const { return static_cast<std::uint32_t>(all.size()); }
  std::uint32_t at(const Place& place) const { return begin[place.chunk] + place.number; }
};

/// Triangle t has the corners 3t, 3t + 1 and 3t + 2; each corner stands for the half-edge that
/// leaves it.
struct TriangleMesh {
  std::span<const Vec3> positions;               ///< of the points; -0 stands for 0
  std::span<const std::uint32_t> input_corners;  ///< their points, in the order of the input
  UnsetVector<std::uint32_t> source;             ///< per triangle: the face of the input

  /// The first triangle of each chunk, and the end.
  std::vector<std::uint32_t> chunk_begins;
  static constexpr std::uint32_t most_of_a_chunk = faces_of_a_block + 2 * few_faces;
  std::vector<TriangleChunk> chunks;
  ChunkBorders borders;

  // Only for chunks where they are asked for: see find_mates().
  UnsetVector<std::uint32_t> corners;  ///< their points
  /// Per corner: the one whose half-edge runs the other way between the same points.
  UnsetVector<std::uint32_t> mate;

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(source.size()); }
  std::uint32_t chunk_count() const { return static_cast<std::uint32_t>(chunk_begins.size() - 1); }
  std::uint32_t chunk_begin(std::uint32_t c) const { return chunk_begins[c]; }
  std::uint32_t chunk_end(std::uint32_t c) const { return chunk_begins[c + 1]; }
  std::uint32_t chunk_of(std::uint32_t triangle) const {
    const auto behind = std::upper_bound(chunk_begins.begin(), chunk_begins.end(), triangle);
    return static_cast<std::uint32_t>(behind - chunk_begins.begin() - 1);
  }
  std::uint32_t corner_of(std::uint32_t border) const {
    return 3 * chunk_begin(borders.own[border].chunk) + borders.all[border].corner;
  }

  static std::uint32_t next(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  static std::uint32_t prev(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  PointId from(std::uint32_t corner) const { return PointId(corners[corner]); }
  PointId to(std::uint32_t corner) const { return PointId(corners[next(corner)]); }
  Vec3 position(PointId p) const {
    const Vec3& at = positions[p.value()];
    return {at.x + 0.0, at.y + 0.0, at.z + 0.0};
  }
};

}  // namespace sectile
