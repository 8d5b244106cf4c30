#include "import/triangles/triangle_blocks.h"

#include <algorithm>
#include <array>

#include "parallel/parallel.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

class BlockMaker {
 public:
  BlockMaker(const TriangleMesh& mesh, const FlatPart& part, std::uint32_t origin)
      : mesh_(mesh), part_(part), origin_(origin), local_(mesh.corners.size()) {}

  TriangleBlocks run() {
    made_.slots.resize(mesh_.chunk_count());
    blocks_.resize(mesh_.chunk_count());
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
    std::size_t triangles = 0;
    for_each_triangle(chunk, [&](std::uint32_t) { ++triangles; });
    if (triangles == 0) return;
    blocks_[chunk] = std::make_shared<Block>();
    Block& block = *blocks_[chunk];
    number_half_edges(chunk, block);
    add_vertices(chunk, triangles, block);
    add_faces(chunk, triangles, block);
    block.bounds();
    block.pieces();
  }

  // Those on the border first.
  void number_half_edges(std::uint32_t chunk, Block& block) {
    std::uint32_t next = 0;
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (!leaves(corner, chunk)) return;
      local_[corner] = HalfEdgeId(next);
      next += 2;
    });
    block.border_count = next / 2;
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (local_[corner].valid()) return;
      local_[corner] = HalfEdgeId(next);
      local_[mesh_.mate[corner]] = HalfEdgeId(next + 1);
      next += 2;
    });
    Brep& brep = block.brep;
    brep.resize_half_edges(next);
  }

  // In the order in which they are met; points have their numbers.
  void add_vertices(std::uint32_t chunk, std::size_t triangles, Block& block) const {
    Brep& brep = block.brep;
    std::array<std::uint32_t, std::size_t(3) * TriangleMesh::most_of_a_chunk> numbers;
    std::fill_n(numbers.begin(), mesh_.vertex_count[chunk], none);
    std::vector<PointId> points;
    points.reserve(triangles);
    brep.vertex_half_edge.reserve(triangles);
    for_each_corner(chunk, [&](std::uint32_t corner) {
      const HalfEdgeId h = local_[corner];
      std::uint32_t& known = numbers[mesh_.vertex[corner]];
      if (known == none) {
        known = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh_.from(corner));
        brep.vertex_half_edge.add(h);
      }
      brep.origin[h] = VertexId(known);
    });
    Geometry& geometry = block.geometry();
    geometry.positions.reserve(points.size());
    geometry.construct.reserve(points.size());
    brep.point.reserve(points.size());
    for (const PointId p : points) brep.point.add(geometry.add_point(mesh_.geometry->position(p)));
  }

  void add_faces(std::uint32_t chunk, std::size_t triangles, Block& block) const {
    Brep& brep = block.brep;
    brep.reserve_faces(triangles);
    block.geometry().planes.reserve(triangles);
    for_each_triangle(chunk, [&](std::uint32_t t) {
      const HalfEdgeId h[] = {local_[3 * t], local_[3 * t + 1], local_[3 * t + 2]};
      const LoopId loop(brep.outer_loop.size());
      for (std::size_t k = 0; k < 3; ++k) {
        brep.next[h[k]] = h[(k + 1) % 3];
        brep.prev[h[k]] = h[(k + 2) % 3];
        brep.loop[h[k]] = loop;
        if (block.is_border(h[k])) brep.origin[Brep::twin(h[k])] = brep.from(h[(k + 1) % 3]);
      }
      const PlaneId plane = block.geometry().add_plane(
          PlaneDefinition::through(point(brep, h[0]), point(brep, h[1]), point(brep, h[2])));
      brep.add_loop(brep.add_face(plane, {origin_, mesh_.source[t]}, loop), h[0]);
    });
  }
  static PointId point(const Brep& brep, HalfEdgeId h) { return brep.point_of(brep.from(h)); }

  BorderEdge border_edge(std::uint32_t corner) const {
    const std::uint32_t slot = mesh_.chunk_of(corner);
    const HalfEdgeId h = local_[corner];
    const Block& block = *blocks_[slot];
    const Pieces& pieces = block.pieces();
    // Nearly all blocks are in one piece: their faces are not looked at.
    return {slot, h.value() / 2,
            pieces.count == 1 ? 0 : pieces.of_face[block.brep.face_of(h).value()]};
  }

  void link(std::uint32_t chunk) {
    if (!blocks_[chunk] || blocks_[chunk]->border_count == 0) return;
    std::vector<BorderLink> links(blocks_[chunk]->border_count);
    for_each_corner(chunk, [&](std::uint32_t corner) {
      if (!leaves(corner, chunk) || part_.holds[mesh_.mate[corner] / 3] != 0) return;
      const BorderEdge other = border_edge(mesh_.mate[corner]);
      links[local_[corner].value() / 2] = {static_cast<std::int32_t>(other.slot - chunk),
                                           other.border, other.piece};
    });
    made_.slots[chunk].links = std::make_shared<const BorderLinks>(std::move(links));
  }

  const TriangleMesh& mesh_;
  const FlatPart& part_;
  std::uint32_t origin_;
  std::vector<HalfEdgeId> local_;  // per corner: in its block
  std::vector<std::shared_ptr<Block>> blocks_;
  TriangleBlocks made_;
};

}  // namespace

TriangleBlocks make_triangle_blocks(const TriangleMesh& mesh, const FlatPart& part,
                                    std::uint32_t origin) {
  return BlockMaker(mesh, part, origin).run();
}

}  // namespace sectile
