#include "import/triangles/read_chunks.h"

#include <array>
#include <atomic>
#include <numeric>
#include <utility>

#include "import/triangles/chunk_borders.h"
#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

template <class Body>
void for_each_range_of_chunks(const TriangleMesh& mesh, const Body& body) {
  parallel::loop(parallel::Range<std::uint32_t>(0, mesh.chunk_count(), 8), body);
}

bool read_chunks(ChunkReaders& readers, std::span<TriangleChunk* const> known,
                 std::span<std::uint32_t> marks, TriangleMesh& mesh) {
  mesh.chunks.resize(mesh.chunk_count());
  std::atomic<bool> plain = true;
  for_each_range_of_chunks(mesh, [&](const auto& range) {
    readers.lend([&](ChunkReader& reader) {
      for (std::uint32_t c = range.begin(); c < range.end() && plain; ++c)
        if (!known.empty() && known[c])
          mesh.chunks[c] = std::move(*known[c]);
        else if (!reader.read(mesh, c, marks, mesh.chunks[c]))
          plain = false;
    });
  });
  return plain;
}

// The pieces of chunks hang together over borders.
class ShellFinder {
 public:
  explicit ShellFinder(const TriangleMesh& mesh) : mesh_(mesh), first_piece_{0} {
    for (const TriangleChunk& chunk : mesh.chunks)
      first_piece_.push_back(first_piece_.back() + chunk.triangles.piece_count);
  }

  ShellOfTriangle run() const {
    const ChunkBorders& borders = mesh_.borders;
    DisjointSets sets(first_piece_.back());
    for (std::uint32_t b = 0; b < borders.count(); ++b)
      if (borders.own[b].chunk < borders.beyond[b].chunk)
        sets.unite(piece_at(b), piece_at(borders.at(borders.beyond[b])));
    const auto [set, count] = std::move(sets).numbered();
    if (count == 1) return {};
    ShellOfTriangle shells{count, {}};
    shells.of.reserve(mesh_.triangle_count());
    for (std::uint32_t c = 0; c < mesh_.chunk_count(); ++c)
      for (std::uint32_t t = 0; t < mesh_.chunk_end(c) - mesh_.chunk_begin(c); ++t)
        shells.of.push_back(set[piece_of(c, t)]);
    return shells;
  }

 private:
  std::uint32_t piece_of(std::uint32_t chunk, std::uint32_t triangle) const {
    const std::uint32_t first = first_piece_[chunk];
    const bool is_one = first_piece_[chunk + 1] - first == 1;
    return is_one ? first : first + mesh_.chunks[chunk].triangles.piece[triangle];
  }
  std::uint32_t piece_at(std::uint32_t border) const {
    return piece_of(mesh_.borders.own[border].chunk, mesh_.borders.all[border].corner / 3u);
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> first_piece_;  // per chunk, and the end
};

void find_mates_in(TriangleMesh& mesh, std::uint32_t chunk) {
  const CompactTriangles& made = mesh.chunks[chunk].triangles;
  const std::uint32_t first = 3 * mesh.chunk_begin(chunk);
  const auto inner = static_cast<std::uint32_t>(2 * made.border.size());
  std::array<std::uint32_t, std::size_t(6) * TriangleMesh::most_of_a_chunk> corner_of;
  for (std::uint32_t i = 0; i < 3 * made.triangles.size(); ++i) {
    const CompactTriangles::Triangle& triangle = made.triangles[i / 3];
    mesh.corners[first + i] = mesh.input_corners[3 * std::size_t(triangle.source) + i % 3];
    corner_of[triangle.half_edge[i % 3]] = first + i;
  }
  const ChunkBorders& borders = mesh.borders;
  for (std::uint32_t b = 0; b < made.border.size(); ++b)
    mesh.mate[first + made.border[b].corner] =
        mesh.corner_of(borders.at(borders.beyond[borders.at({chunk, b})]));
  for (std::uint32_t h = inner; h < made.half_edge_count; ++h)
    mesh.mate[corner_of[h]] = corner_of[h ^ 1u];
}

}  // namespace

std::optional<ShellOfTriangle> read_surface(ChunkReaders& readers, TriangleMesh& mesh) {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::vector<std::uint32_t> marks(mesh.positions.size(), none);
  if (!read_chunks(readers, {}, marks, mesh) || !match_borders(mesh)) return {};
  ShellOfTriangle shells;
  bool is_plain = false;
  parallel::invoke([&] { shells = ShellFinder(mesh).run(); },
                   [&] { is_plain = has_plain_points(mesh, marks); });
  if (!is_plain) return {};
  return shells;
}

void read_shell(ChunkReaders& readers, std::span<TriangleChunk* const> known, TriangleMesh& mesh) {
  if (!read_chunks(readers, known, {}, mesh) || !match_borders(mesh))
    throw InternalError("a shell of a closed surface is not closed");
}

void find_mates(TriangleMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.chunk_count());
  std::iota(all.begin(), all.end(), 0u);
  find_mates(mesh, all);
}

void find_mates(TriangleMesh& mesh, std::span<const std::uint32_t> chunks) {
  mesh.corners.resize(3 * mesh.source.size());
  mesh.mate.resize(3 * mesh.source.size());
  parallel::loop(parallel::Range<std::size_t>(0, chunks.size(), 8), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) find_mates_in(mesh, chunks[i]);
  });
}

}  // namespace sectile
