#include "import/triangles/triangle_blocks.h"

#include <algorithm>
#include <array>

#include "parallel/parallel.h"

namespace sectile {
namespace {

// The half-edges and vertices of a chunk have numbers of so many bits
// (storage/compact_triangles.h).
constexpr std::uint16_t none = 0xFFFF;
static_assert(6 * TriangleMesh::most_of_a_chunk < none);

class BlockMaker {
 public:
  BlockMaker(TriangleMesh& mesh, const FlatPart& part, std::uint32_t origin)
      : mesh_(mesh), part_(part), origin_(origin), remains_(mesh.chunk_count()) {}

  TriangleBlocks run() {
    made_.slots.resize(mesh_.chunk_count());
    in_one_piece_.resize(mesh_.chunk_count());
    for_each_chunk([&](std::uint32_t c) { make(c); });
    for_each_chunk([&](std::uint32_t c) { link(c); });
    for (const std::uint32_t corner : part_.open) made_.outside.push_back(outside(corner));
    return std::move(made_);
  }

 private:
  template <class Body>
  void for_each_chunk(const Body& body) const {
    parallel::loop(parallel::Range<std::uint32_t>(0, mesh_.chunk_count(), 8),
                   [&](const auto& range) {
                     for (std::uint32_t c = range.begin(); c < range.end(); ++c) body(c);
                   });
  }
  template <class Visit>
  void for_each_triangle(std::uint32_t chunk, const Visit& visit) const {
    for (std::uint32_t t = mesh_.chunk_begin(chunk); t < mesh_.chunk_end(chunk); ++t)
      if (part_.holds[t] == 0) visit(t);
  }
  template <class Visit>
  void for_each_corner(std::uint32_t chunk, const Visit& visit) const {
    for_each_triangle(chunk, [&](std::uint32_t t) {
      for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) visit(corner);
    });
  }
  std::size_t size_of(std::uint32_t chunk) const {
    return mesh_.chunk_end(chunk) - mesh_.chunk_begin(chunk);
  }
  bool is_whole(std::uint32_t chunk) const {
    return part_.triangles.empty() ||
           std::none_of(part_.holds.begin() + mesh_.chunk_begin(chunk),
                        part_.holds.begin() + mesh_.chunk_end(chunk),
                        [](std::uint8_t is_held) { return is_held != 0; });
  }
  const CompactTriangles& read(std::uint32_t chunk) const { return mesh_.chunks[chunk].triangles; }

  void make(std::uint32_t chunk) {
    CompactTriangles made;
    if (is_whole(chunk)) {
      made = std::move(mesh_.chunks[chunk].triangles);
    } else {
      number_half_edges(chunk, made);
      if (made.half_edge_count == 0) return;
      add_remains(chunk, made);
    }
    made.origin = origin_;
    made_.slots[chunk].block = std::make_shared<const Block>(std::move(made));
    in_one_piece_[chunk] = made_.slots[chunk].block->pieces().count() == 1;
  }

  // Those on the border first.
  void number_half_edges(std::uint32_t chunk, CompactTriangles& made) {
    std::vector<std::uint16_t>& remains = remains_[chunk];
    remains.assign(3 * size_of(chunk), none);
    const std::uint32_t first = 3 * mesh_.chunk_begin(chunk), end = 3 * mesh_.chunk_end(chunk);
    std::uint16_t next = 0;
    const auto take = [&](std::uint32_t corner) { remains[corner - first] = next++; };
    for_each_corner(chunk, [&](std::uint32_t corner) {
      const std::uint32_t beyond = mesh_.mate[corner];
      if (first <= beyond && beyond < end && part_.holds[beyond / 3] == 0) return;
      take(corner);
      ++next;
    });
    made.border.resize(next / 2u);
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (remains[corner - first] != none) return;
      take(corner);
      take(mesh_.mate[corner]);
    });
    made.half_edge_count = next;
  }

  // Vertices in the order in which they are met.
  void add_remains(std::uint32_t chunk, CompactTriangles& made) const {
    std::array<std::uint16_t, std::size_t(3) * TriangleMesh::most_of_a_chunk> numbers;
    std::fill_n(numbers.begin(), read(chunk).positions.size(), none);
    made.positions.reserve(read(chunk).positions.size());
    made.triangles.reserve(size_of(chunk));
    for_each_triangle(chunk, [&](std::uint32_t t) {
      const std::uint32_t place = t - mesh_.chunk_begin(chunk);
      const std::size_t corner = 3 * made.triangles.size();
      CompactTriangles::Triangle& triangle =
          made.triangles.emplace_back(read(chunk).triangles[place]);
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint16_t& known = numbers[triangle.vertex[k]];
        if (known == none) {
          known = static_cast<std::uint16_t>(made.positions.size());
          made.positions.push_back(read(chunk).positions[triangle.vertex[k]]);
        }
        triangle.vertex[k] = known;
        triangle.half_edge[k] = remains_[chunk][3 * place + k];
      }
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::size_t e = triangle.half_edge[k] / 2u; e < made.border.size())
          made.border[e] = {static_cast<std::uint16_t>(corner + k), triangle.vertex[k],
                            triangle.vertex[k < 2 ? k + 1 : 0]};
    });
  }

  // The number of a border edge in its block. It is what it was in the chunk, if that is whole.
  std::uint32_t number_of(std::uint32_t border) const {
    const auto [chunk, number] = mesh_.borders.own[border];
    const std::vector<std::uint16_t>& remains = remains_[chunk];
    return remains.empty() ? number : remains[mesh_.borders.all[border].corner] / 2u;
  }
  // Nearly all blocks are in one piece, and are not looked at.
  BorderEdge border_edge(std::uint32_t border) const {
    const std::uint32_t slot = mesh_.borders.own[border].chunk;
    return {slot, number_of(border),
            in_one_piece_[slot] != 0 ? 0 : piece(slot, mesh_.borders.all[border].corner / 3u)};
  }
  std::uint32_t piece(std::uint32_t slot, std::uint32_t place_in_chunk) const {
    std::uint32_t face = place_in_chunk;
    if (!remains_[slot].empty()) {
      const auto holds = part_.holds.begin() + mesh_.chunk_begin(slot);
      face -= static_cast<std::uint32_t>(std::count(holds, holds + place_in_chunk, 1));
    }
    return made_.slots[slot].block->pieces().of(FaceId(face));
  }

  // Links to the part lead nowhere yet.
  void link(std::uint32_t chunk) {
    if (made_.slots[chunk].empty() || made_.slots[chunk].block->border_count == 0) return;
    std::vector<BorderLink> links(made_.slots[chunk].block->border_count);
    for (std::uint32_t b = mesh_.borders.begin[chunk]; b < mesh_.borders.begin[chunk + 1]; ++b) {
      if (is_beside_part(b)) continue;
      const BorderEdge other = border_edge(mesh_.borders.at(mesh_.borders.beyond[b]));
      links[number_of(b)] = {static_cast<std::int32_t>(other.slot - chunk), other.border,
                             other.piece};
    }
    made_.slots[chunk].links = std::make_shared<const BorderLinks>(std::move(links));
  }
  bool is_beside_part(std::uint32_t border) const {
    const std::uint32_t beyond = mesh_.borders.at(mesh_.borders.beyond[border]);
    return is_in_part(border) || is_in_part(beyond);
  }
  bool is_in_part(std::uint32_t border) const {
    return !remains_[mesh_.borders.own[border].chunk].empty() &&
           part_.holds[mesh_.corner_of(border) / 3] != 0;
  }

  // An edge that leaves the part, seen from the block beside it.
  BorderEdge outside(std::uint32_t corner_of_part) const {
    const std::uint32_t corner = mesh_.mate[corner_of_part], slot = mesh_.chunk_of(corner / 3);
    const std::uint32_t place = corner - 3 * mesh_.chunk_begin(slot);
    if (!remains_[slot].empty())
      return {slot, remains_[slot][place] / 2u,
              in_one_piece_[slot] != 0 ? 0 : piece(slot, place / 3)};
    const auto borders = std::span(mesh_.borders.all);
    std::uint32_t b = mesh_.borders.begin[slot];
    while (borders[b].corner != place) ++b;
    return border_edge(b);
  }

  TriangleMesh& mesh_;
  const FlatPart& part_;
  std::uint32_t origin_;
  // Per chunk: the half-edges of its corners, without the triangles in the part. Empty if it is
  // whole.
  std::vector<std::vector<std::uint16_t>> remains_;
  std::vector<std::uint8_t> in_one_piece_;
  TriangleBlocks made_;
};

}  // namespace

TriangleBlocks make_triangle_blocks(TriangleMesh&& mesh, const FlatPart& part,
                                    std::uint32_t origin) {
  return BlockMaker(mesh, part, origin).run();
}

}  // namespace sectile
