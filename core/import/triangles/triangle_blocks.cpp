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
  BlockMaker(const TriangleMesh& mesh, const FlatPart& part, std::uint32_t origin)
      : mesh_(mesh), part_(part), origin_(origin), local_(mesh.corners.size(), none) {}

  TriangleBlocks run() {
    made_.slots.resize(mesh_.chunk_count());
    blocks_.resize(mesh_.chunk_count());
    in_one_piece_.resize(mesh_.chunk_count());
    leaving_.resize(mesh_.chunk_count());
    for_each_chunk([&](std::uint32_t c) { make(c); });
    for_each_chunk([&](std::uint32_t c) { link(c); });
    for (const std::uint32_t corner : part_.open)
      made_.outside.push_back(border_edge(mesh_.mate[corner]));
    for (std::size_t c = 0; c < blocks_.size(); ++c) made_.slots[c].block = std::move(blocks_[c]);
    return std::move(made_);
  }

 private:
  template <class Body>
  void for_each_chunk(const Body& body) const {
    parallel::loop(tbb::blocked_range<std::uint32_t>(0, mesh_.chunk_count(), 8),
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

  bool leaves(std::uint32_t corner, std::uint32_t chunk) const {
    const std::uint32_t beyond = mesh_.mate[corner];
    return !mesh_.is_in_chunk(beyond, chunk) || part_.holds[beyond / 3] != 0;
  }

  void make(std::uint32_t chunk) {
    CompactTriangles made;
    number_half_edges(chunk, made);
    if (made.half_edge_count == 0) return;
    made.origin = origin_;
    add_triangles(chunk, made);
    blocks_[chunk] = std::make_shared<const Block>(std::move(made));
    in_one_piece_[chunk] = blocks_[chunk]->pieces().count() == 1;
  }

  // Those on the border first.
  void number_half_edges(std::uint32_t chunk, CompactTriangles& made) {
    std::uint16_t next = 0;
    const auto take = [&](std::uint32_t corner) { local_[corner] = next++; };
    std::vector<std::uint32_t> leaving;
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (!leaves(corner, chunk)) return;
      leaving.push_back(corner);
      take(corner);
      ++next;
    });
    made.border_count = next / 2u;
    leaving_[chunk] = std::move(leaving);
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (local_[corner] != none) return;
      take(corner);
      take(mesh_.mate[corner]);
    });
    made.half_edge_count = next;
  }

  // Vertices in the order in which they are met.
  void add_triangles(std::uint32_t chunk, CompactTriangles& made) const {
    std::array<std::uint16_t, std::size_t(3) * TriangleMesh::most_of_a_chunk> numbers;
    std::fill_n(numbers.begin(), mesh_.vertex_count[chunk], none);
    made.positions.reserve(mesh_.vertex_count[chunk]);
    const std::size_t all = mesh_.chunk_end(chunk) - mesh_.chunk_begin(chunk);
    made.triangles.reserve(all);
    for_each_triangle(chunk, [&](std::uint32_t t) {
      CompactTriangles::Triangle& triangle =
          made.triangles.emplace_back(CompactTriangles::Triangle{{}, {}, mesh_.source[t]});
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = 3 * t + k;
        std::uint16_t& known = numbers[mesh_.vertex[corner]];
        if (known == none) {
          known = static_cast<std::uint16_t>(made.positions.size());
          made.positions.push_back(mesh_.position(corner));
        }
        triangle.vertex[k] = known;
        triangle.half_edge[k] = local_[corner];
      }
    });
    made.hangs_together = made.triangles.size() == all && !mesh_.hangs_together.empty() &&
                          mesh_.hangs_together[chunk] != 0;
  }

  BorderEdge border_edge(std::uint32_t corner) const {
    const std::uint32_t slot = mesh_.chunk_of(corner);
    // Nearly all blocks are in one piece, and are not looked at.
    return {
        slot, local_[corner] / 2u,
        in_one_piece_[slot] != 0 ? 0 : blocks_[slot]->pieces().of(face_in_block(corner / 3, slot))};
  }
  FaceId face_in_block(std::uint32_t triangle, std::uint32_t slot) const {
    std::uint32_t before = 0;
    for_each_triangle(slot, [&](std::uint32_t t) {
      if (t < triangle) ++before;
    });
    return FaceId(before);
  }

  void link(std::uint32_t chunk) {
    if (leaving_[chunk].empty()) return;
    std::vector<BorderLink> links;
    links.reserve(leaving_[chunk].size());
    for (const std::uint32_t corner : leaving_[chunk]) {
      BorderLink& link = links.emplace_back();
      const std::uint32_t mate = mesh_.mate[corner];
      if (part_.holds[mate / 3] != 0) continue;
      const BorderEdge other = border_edge(mate);
      link = {static_cast<std::int32_t>(other.slot - chunk), other.border, other.piece};
    }
    made_.slots[chunk].links = std::make_shared<const BorderLinks>(std::move(links));
  }

  const TriangleMesh& mesh_;
  const FlatPart& part_;
  std::uint32_t origin_;
  std::vector<std::uint16_t> local_;                 // per corner: its half-edge in its block
  std::vector<std::vector<std::uint32_t>> leaving_;  // per chunk: the corners on its border
  std::vector<std::shared_ptr<const Block>> blocks_;
  std::vector<std::uint8_t> in_one_piece_;
  TriangleBlocks made_;
};

}  // namespace

TriangleBlocks make_triangle_blocks(const TriangleMesh& mesh, const FlatPart& part,
                                    std::uint32_t origin) {
  return BlockMaker(mesh, part, origin).run();
}

}  // namespace sectile
