// The triangles of a boundary, block by block: without joining the blocks first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "numbers/unset_vector.h"
#include "storage/block_elements.h"
#include "storage/solid_data.h"

namespace sectile {

struct BlockTriangles {
  /// Vertices of blocks have numbers in the whole solid, from first_vertex[slot] on. That of the
  /// mesh is the same for all that are one vertex.
  std::vector<std::uint32_t> first_vertex;  ///< and the end of them all
  UnsetVector<std::uint32_t> number;
  std::uint32_t vertex_count = 0;
  /// Per slot: the mesh's first vertex that no slot before it has.
  std::vector<std::uint32_t> first_own;
  /// Per slot: its first triangle, and the end of them all.
  std::vector<std::uint32_t> first_triangle;
  std::vector<std::uint32_t> indices;  ///< three vertices of the mesh for each triangle
  std::vector<FaceSource> source;      ///< per triangle
  std::vector<std::uint32_t> cut;      ///< triangles of faces with more corners, ascending

  std::uint32_t vertex(std::uint32_t slot, VertexId local) const {
    return number[first_vertex[slot] + local.value()];
  }
  /// Calls visit(vertex of the mesh, position, is_exact) for those that no slot before has: each
  /// vertex of the mesh is visited once.
  template <class Visit>
  void each_own_vertex(std::uint32_t slot, const Block& block, const Visit& visit) const {
    const std::uint32_t* const numbers = number.data() + first_vertex[slot];
    std::uint32_t next = first_own[slot];
    BlockElements(block).each_vertex([&](std::uint32_t v, const Vec3& p, bool is_exact) {
      if (numbers[v] == next) visit(next++, p, is_exact);
    });
  }
};

/// Nothing if several vertices may be at one point, or the edges of a face touch each other.
std::optional<BlockTriangles> block_triangles(const SolidData& data);

}  // namespace sectile
