// From the chunks of a mesh of triangles to all of it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "import/triangles/chunk_reader.h"
#include "import/triangles/triangle_mesh.h"
#include "parallel/scratch.h"

namespace sectile {

using ChunkReaders = parallel::Scratch<ChunkReader>;

/// The shells, in the order of their first triangles.
struct ShellOfTriangle {
  std::uint32_t count = 1;
  std::vector<std::uint32_t> of;  ///< per triangle; empty if there is one shell
};

/// Finds all about the triangles of a mesh, whose order along the curve and whose chunks are known.
/// None if any may have no area, or the mesh is not a surface with two triangles at each edge and
/// one cycle of triangles around each point.
std::optional<ShellOfTriangle> read_surface(ChunkReaders& readers, TriangleMesh& mesh);
/// The same, where it is known to be such a surface. `known` has the chunks that were read before,
/// as chunks of a mesh around the shell, and nothing for the others.
void read_shell(ChunkReaders& readers, std::span<TriangleChunk* const> known, TriangleMesh& mesh);

/// Sets `corners` and `mate` of all chunks, or of some, once all are read.
void find_mates(TriangleMesh& mesh);
void find_mates(TriangleMesh& mesh, std::span<const std::uint32_t> chunks);

}  // namespace sectile
