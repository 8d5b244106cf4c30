// All that can be found out about one chunk of a mesh of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/four_points.h"
#include "import/triangles/chunk_tables.h"
#include "import/triangles/triangle_mesh.h"

namespace sectile {

class ChunkReader {
 public:
  /// What a point is marked with around which all triangles are in one chunk.
  static constexpr std::uint32_t within = 0xFFFFFFFEu;

  /// Finds all about a chunk, and marks points within it, where marks are wanted. False if a
  /// triangle may have no area, an edge has more than two triangles or two that run the same way
  /// along it, or several cycles of triangles go around a vertex.
  bool read(const TriangleMesh& mesh, std::uint32_t chunk, std::span<std::uint32_t> marks,
            TriangleChunk& result);

 private:
  // Room for the numbers of corners that stand for none, so that nobody has to ask.
  static constexpr std::size_t most = ChunkLines::none + 1;
  static constexpr std::size_t most_triangles = TriangleMesh::most_of_a_chunk;
  static constexpr std::uint16_t none = ChunkLines::none;

  void gather(const TriangleMesh& mesh);
  bool measure(const Vec3& origin);
  bool match();
  void number_half_edges();
  bool has_plain_vertices();
  void find_flat_edges();
  void add_triangles(const TriangleMesh& mesh);
  void find_pieces();
  void add_borders();
  void add_chords();
  void mark_points(std::span<std::uint32_t> marks) const;

  static std::uint16_t next(std::uint16_t corner) {
    return static_cast<std::uint16_t>(TriangleMesh::next(corner));
  }
  static std::uint16_t prev(std::uint16_t corner) {
    return static_cast<std::uint16_t>(TriangleMesh::prev(corner));
  }
  const Vec3& position(std::uint16_t corner) const { return position_[vertex_[corner]]; }
  std::uint32_t point(std::uint16_t corner) const { return point_[vertex_[corner]]; }

  TriangleChunk* result_ = nullptr;
  std::uint32_t first_ = 0;                   // triangle of the mesh
  std::uint16_t corners_ = 0, vertices_ = 0;  // how many

  PointNumbers numbers_;
  ChunkLines lines_;
  // Per vertex.
  std::array<Vec3, most> position_;
  std::array<std::uint32_t, most> point_;
  std::array<std::uint16_t, most> some_corner_;
  std::array<std::uint8_t, most> on_border_;
  // Per corner.
  std::array<std::uint32_t, most> input_;
  std::array<std::uint16_t, most> vertex_{}, mate_{}, half_edge_{};
  // Per triangle.
  std::array<NormalOfThree, most_triangles> normal_;
  std::array<std::uint16_t, most_triangles> piece_;

  // The corners that leave the chunk, and the first of each inner edge.
  std::array<std::uint16_t, most> border_, inner_;
  std::array<std::uint16_t, most> around_;  // per border: the next one around its vertex
  std::uint16_t border_count_ = 0, inner_count_ = 0;
};

}  // namespace sectile
