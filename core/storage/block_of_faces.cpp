#include "storage/block_of_faces.h"

#include <algorithm>

#include "storage/geometry_loader.h"

namespace sectile {

void BlockOfFaces::fill() {
  const std::vector<VertexId> vertices = number_vertices();
  reserve(vertices.size());
  GeometryLoader geometry(geometry_, block_->geometry(), expected_vertices());
  add_faces(geometry);
  add_vertices(vertices, geometry);
  add_edge_planes(geometry);
  add_touching_vertices(vertices);
  block_->bounds();
  block_->pieces();
}

// In the order in which they are met.
std::vector<VertexId> BlockOfFaces::number_vertices() {
  Brep& to = block_->brep();
  std::vector<VertexId> vertices;
  vertices.reserve(expected_vertices());
  IdMap numbers(expected_vertices(), brep_.vertex_count());
  for_each_half_edge([&](HalfEdgeId h) {
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
void BlockOfFaces::reserve(std::size_t vertices) {
  block_->brep().reserve_faces(faces_.size());
  block_->brep().point.reserve(vertices);
  block_->geometry().positions.reserve(vertices);
  block_->geometry().construct.reserve(vertices);
  block_->geometry().planes.reserve(faces_.size());
}

void BlockOfFaces::add_faces(GeometryLoader& geometry) {
  Brep& to = block_->brep();
  for (const FaceId f : faces_) {
    const FaceId mine =
        to.add_face(geometry.plane(brep_.plane[f]), brep_.source[f], LoopId(to.loop_count()));
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      const LoopId next(to.loop_count() + 1);
      add_loop(l, to.add_loop(mine, local_[brep_.loop_half_edge[l].value()],
                              brep_.next_loop[l].valid() ? next : LoopId()));
    }
  }
}

void BlockOfFaces::add_loop(LoopId loop, LoopId made) {
  Brep& to = block_->brep();
  for_each_in_loop(brep_, loop, [&](HalfEdgeId h) {
    const HalfEdgeId here = local_[h.value()], after = local_[brep_.next_of(h).value()];
    to.next[here] = after;
    to.prev[after] = here;
    to.loop[here] = made;
  });
}

void BlockOfFaces::add_vertices(const std::vector<VertexId>& vertices, GeometryLoader& geometry) {
  Brep& to = block_->brep();
  for (const VertexId v : vertices) to.point.add(geometry.point(brep_.point_of(v)));
  for (std::uint32_t e = 0; e < block_->border_count; ++e) {
    const HalfEdgeId h = Brep::half_edge(EdgeId(e));
    to.origin[Brep::twin(h)] = to.from(to.next_of(h));
  }
}

void BlockOfFaces::add_edge_planes(GeometryLoader& geometry) {
  if (brep_.edge_plane.empty()) return;
  Brep& to = block_->brep();
  for_each_half_edge([&](HalfEdgeId h) {
    const PlaneId plane = brep_.edge_plane[Brep::edge_of(h)];
    const HalfEdgeId here = local_[h.value()];
    if (!plane.valid() || here.value() % 2 != 0) return;
    if (to.edge_plane.empty()) to.edge_plane.resize(to.edge_count());
    to.edge_plane[Brep::edge_of(here)] = geometry.plane(plane);
  });
}

void BlockOfFaces::add_touching_vertices(std::span<const VertexId> vertices) {
  std::vector<VertexId> touching;
  for (std::size_t v = 0; !touching_.empty() && v < vertices.size(); ++v)
    if (std::binary_search(touching_.begin(), touching_.end(), vertices[v]))
      touching.push_back(VertexId(v));
  block_->set_touching_vertices(std::move(touching));
}

}  // namespace sectile
