#include "storage/cut_into_blocks.h"

#include <numeric>

#include "parallel/parallel.h"
#include "search/curve_order.h"
#include "search/face_tree.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

constexpr std::size_t corners_of_a_block = 4096;
constexpr std::uint32_t none = 0xFFFFFFFFu;

// Faces in the order of a curve that fills space, in groups.
class Groups {
 public:
  explicit Groups(const PartToCut& part) : part_(part), of_face_(part.brep.face_count(), none) {
    const std::vector<std::uint32_t> most = most_faces();
    std::size_t corners = 0;
    for (const std::uint32_t f : faces_in_order()) {
      const std::size_t more = corners_of(FaceId(f));
      if (faces_.empty() || faces_.size() - end_.back() >= most[shell(f)] ||
          shell(f) != shell(faces_.back().value()) || corners + more > corners_of_a_block) {
        end_.push_back(static_cast<std::uint32_t>(faces_.size()));
        corners = 0;
      }
      corners += more;
      faces_.push_back(FaceId(f));
      of_face_[f] = static_cast<std::uint32_t>(end_.size() - 1);
    }
    end_.push_back(static_cast<std::uint32_t>(faces_.size()));
  }

  std::size_t count() const { return end_.size() - 1; }
  std::span<const FaceId> operator[](std::size_t g) const {
    return std::span(faces_).subspan(end_[g], end_[g + 1] - end_[g]);
  }
  /// None for faces that stand for what is outside.
  std::uint32_t of(FaceId f) const { return of_face_[f.value()]; }

 private:
  std::size_t corners_of(FaceId f) const {
    std::size_t corners = 0;
    for_each_in_face(part_.brep, f, [&](HalfEdgeId) { ++corners; });
    return corners;
  }

  std::uint32_t shell(std::uint32_t f) const { return part_.shell.empty() ? 0 : part_.shell[f]; }

  std::vector<std::uint32_t> sizes_of_shells() const {
    std::vector<std::uint32_t> size(1, 0);
    for (const std::uint32_t s : part_.shell) {
      if (s >= size.size()) size.resize(s + 1, 0);
      ++size[s];
    }
    return size;
  }

  // A small shell stays in one block.
  std::vector<std::uint32_t> most_faces() const {
    std::vector<std::uint32_t> most = sizes_of_shells();
    for (std::uint32_t& n : most)
      if (n == 0 || n > most_faces_of_a_block) n = std::uint32_t(faces_of_a_block);
    return most;
  }

  std::vector<std::uint32_t> faces_in_order() const {
    const Brep& brep = part_.brep;
    std::vector<Box> boxes(brep.face_count());
    parallel::loop(tbb::blocked_range<std::size_t>(0, boxes.size(), 2048), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f)
        if (is_real(f)) boxes[f] = face_box(brep, part_.geometry, FaceId(f));
    });
    Box all;
    for (const Box& b : boxes) all.add(b);
    std::vector<std::uint32_t> at = sizes_of_shells(), faces(brep.face_count());
    std::exclusive_scan(at.begin(), at.end(), at.begin(), 0u);
    std::size_t count = 0;
    for (const std::uint32_t f :
         order_along_curve(boxes.size(), all, [&](std::size_t i) { return boxes[i]; })) {
      if (!is_real(f)) continue;
      faces[at[shell(f)]++] = f;
      ++count;
    }
    faces.resize(count);
    return faces;
  }
  bool is_real(std::size_t f) const { return part_.brep.kind_of(FaceId(f)) == FaceKind::real; }

  const PartToCut& part_;
  std::vector<FaceId> faces_;
  std::vector<std::uint32_t> end_, of_face_;
};

class Cutter {
 public:
  explicit Cutter(const PartToCut& part)
      : part_(part),
        brep_(part.brep),
        groups_(part),
        blocks_(groups_.count()),
        links_(groups_.count()),
        leaving_(groups_.count()),
        local_(brep_.half_edge_count()),
        made_{{}, std::vector<BorderEdge>(part.outside.size())} {
    for (auto& block : blocks_) block = std::make_shared<Block>();
  }

  CutPart run() {
    for_each_group([&](std::size_t g) { number_edges(g); });
    for_each_group([&](std::size_t g) { fill(g); });
    for_each_group([&](std::size_t g) { add_links(g); });
    for (std::size_t g = 0; g < blocks_.size(); ++g) {
      made_.slots.push_back({std::move(blocks_[g]), std::move(links_[g]), false});
    }
    return std::move(made_);
  }

 private:
  template <class Body>
  void for_each_group(const Body& body) const {
    if (blocks_.size() < 4) {
      for (std::size_t g = 0; g < blocks_.size(); ++g) body(g);
    } else {
      parallel::loop(0, blocks_.size(), body);
    }
  }

  template <class Visit>
  void for_each_half_edge(std::size_t g, const Visit& visit) const {
    for (const FaceId f : groups_[g]) for_each_in_face(brep_, f, visit);
  }

  bool leaves(HalfEdgeId h, std::size_t g) const {
    return groups_.of(brep_.face_of(Brep::twin(h))) != g;
  }

  // Border edges first.
  void number_edges(std::size_t g) {
    std::uint32_t next = 0;
    for_each_half_edge(g, [&](HalfEdgeId h) {
      if (!leaves(h, g)) return;
      leaving_[g].push_back(h);
      local_[h.value()] = HalfEdgeId(next);
      next += 2;
    });
    blocks_[g]->border_count = next / 2;
    for_each_half_edge(g, [&](HalfEdgeId h) {
      if (local_[h.value()].valid()) return;
      local_[h.value()] = HalfEdgeId(next);
      local_[Brep::twin(h).value()] = HalfEdgeId(next + 1);
      next += 2;
    });
    blocks_[g]->brep.resize_half_edges(next);
  }

  void fill(std::size_t g) {
    Block& block = *blocks_[g];
    const std::vector<VertexId> vertices = number_vertices(g, block.brep);
    reserve(g, vertices.size(), block);
    GeometryLoader geometry(part_.geometry, block.geometry, groups_[g].size());
    add_faces(g, block.brep, geometry);
    add_vertices(vertices, block, geometry);
    add_edge_planes(g, block.brep, geometry);
    block.bounds();
    block.pieces();
  }

  void add_faces(std::size_t g, Brep& to, GeometryLoader& geometry) const {
    for (const FaceId f : groups_[g]) {
      const FaceId mine =
          to.add_face(geometry.plane(brep_.plane[f]), brep_.source[f], LoopId(to.loop_count()));
      for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
        const LoopId next(to.loop_count() + 1);
        const LoopId loop = to.add_loop(mine, local_[brep_.loop_half_edge[l].value()],
                                        brep_.next_loop[l].valid() ? next : LoopId());
        for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
          const HalfEdgeId here = local_[h.value()], after = local_[brep_.next_of(h).value()];
          to.next[here] = after;
          to.prev[after] = here;
          to.loop[here] = loop;
        });
      }
    }
  }

  // The vertices of a group, numbered in the order in which they are met.
  std::vector<VertexId> number_vertices(std::size_t g, Brep& to) const {
    std::vector<VertexId> vertices;
    vertices.reserve(groups_[g].size());
    IdMap numbers(groups_[g].size());
    for_each_half_edge(g, [&](HalfEdgeId h) {
      std::uint32_t& known = numbers[brep_.from(h).value()];
      if (known == IdMap::none) {
        known = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(brep_.from(h));
        to.vertex_half_edge.add(local_[h.value()]);
      }
      to.origin[local_[h.value()]] = VertexId(known);
    });
    return vertices;
  }

  // Just as much as is needed, as a rule: most of a solid's memory is in its blocks.
  void reserve(std::size_t g, std::size_t vertices, Block& block) const {
    const std::size_t faces = groups_[g].size();
    Brep& brep = block.brep;
    brep.loop_face.reserve(faces);
    brep.loop_half_edge.reserve(faces);
    brep.next_loop.reserve(faces);
    brep.outer_loop.reserve(faces);
    brep.plane.reserve(faces);
    brep.source.reserve(faces);
    brep.point.reserve(vertices);
    block.geometry.positions.reserve(vertices);
    block.geometry.construct.reserve(vertices);
    block.geometry.planes.reserve(faces);
  }

  void add_vertices(const std::vector<VertexId>& vertices, Block& block,
                    GeometryLoader& geometry) const {
    Brep& to = block.brep;
    for (const VertexId v : vertices) to.point.add(geometry.point(brep_.point_of(v)));
    for (std::uint32_t e = 0; e < block.border_count; ++e) {
      const HalfEdgeId h = Brep::half_edge(EdgeId(e));
      to.origin[Brep::twin(h)] = to.from(to.next_of(h));
    }
  }

  void add_edge_planes(std::size_t g, Brep& to, GeometryLoader& geometry) const {
    if (brep_.edge_plane.empty()) return;
    for_each_half_edge(g, [&](HalfEdgeId h) {
      const PlaneId plane = brep_.edge_plane[Brep::edge_of(h)];
      const HalfEdgeId here = local_[h.value()];
      if (!plane.valid() || here.value() % 2 != 0) return;
      if (to.edge_plane.empty()) to.edge_plane.resize(to.edge_count());
      to.edge_plane[Brep::edge_of(here)] = geometry.plane(plane);
    });
  }

  BorderEdge border_edge(std::size_t g, HalfEdgeId h) const {
    const HalfEdgeId here = local_[h.value()];
    const FaceId face = blocks_[g]->brep.face_of(here);
    return {part_.places(g), here.value() / 2, blocks_[g]->pieces().of_face[face.value()]};
  }

  void add_links(std::size_t g) {
    std::vector<BorderLink> links(blocks_[g]->border_count);
    for (const HalfEdgeId h : leaving_[g]) {
      const BorderEdge mine = border_edge(g, h);
      BorderEdge other;
      if (const std::uint32_t beyond = groups_.of(brep_.face_of(Brep::twin(h))); beyond != none) {
        other = border_edge(beyond, Brep::twin(h));
      } else {
        other = part_.outside[Brep::edge_of(h).value()];
        made_.outside[Brep::edge_of(h).value()] = mine;
      }
      links[mine.border] = {static_cast<std::int32_t>(other.slot - mine.slot), other.border,
                            other.piece};
    }
    if (!links.empty())
      links_[g] = std::make_shared<const BorderLinks>(*blocks_[g], std::move(links));
  }

  const PartToCut& part_;
  const Brep& brep_;
  Groups groups_;
  std::vector<std::shared_ptr<Block>> blocks_;
  std::vector<std::shared_ptr<const BorderLinks>> links_;
  std::vector<std::vector<HalfEdgeId>> leaving_;  // per group: its half-edges on the border
  std::vector<HalfEdgeId> local_;                 // per half-edge: in its face's block
  CutPart made_;
};

}  // namespace

CutPart cut_into_blocks(const PartToCut& part) {
  return Cutter(part).run();
}

}  // namespace sectile
