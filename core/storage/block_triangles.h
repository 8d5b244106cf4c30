// The triangles of a boundary, block by block: without joining the blocks first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "storage/solid_data.h"

namespace sectile {

struct BlockTriangles {
  /// Vertices of blocks have numbers in the whole solid, from first_vertex[slot] on. That of the
  /// mesh is the same for all that are one vertex.
  std::vector<std::uint32_t> first_vertex;
  std::vector<std::uint32_t> number;
  std::uint32_t vertex_count = 0;
  /// Per slot: its first triangle, and the end of them all.
  std::vector<std::uint32_t> first_triangle;
  std::vector<std::uint32_t> indices;  ///< three vertices of the mesh for each triangle
  std::vector<FaceSource> source;      ///< per triangle
  std::vector<std::uint32_t> cut;      ///< triangles of faces with more corners, ascending

  std::uint32_t vertex(std::uint32_t slot, VertexId local) const {
    return number[first_vertex[slot] + local.value()];
  }
  /// Is the slot the first one with this vertex of its block?
  bool owns(std::uint32_t slot, VertexId local) const {
    return owner_[first_vertex[slot] + local.value()] != 0;
  }

  std::vector<std::uint8_t> owner_;
};

/// Nothing if several vertices may be at one point, or the edges of a face touch each other.
std::optional<BlockTriangles> block_triangles(const SolidData& data);

}  // namespace sectile
