// Makes a block of some faces of a structure.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "storage/block.h"

namespace sectile {

class BlockOfFaces {
 public:
  /// `local`: per half-edge of the structure. Of those of the faces it will say which they are in
  /// the block; faces of others may be made into blocks beside.
  /// `touching`: vertices at which the structure touches itself, ascending.
  BlockOfFaces(const Brep& brep, const Geometry& geometry, std::span<const FaceId> faces,
               std::span<const VertexId> touching, std::span<HalfEdgeId> local)
      : brep_(brep), geometry_(geometry), faces_(faces), touching_(touching), local_(local) {}

  /// `leaves(HalfEdgeId)`: is the face beyond not one of these?
  template <class Leaves>
  void number_edges(const Leaves& leaves) {
    std::uint32_t next = 0;
    for_each_half_edge([&](HalfEdgeId h) {
      if (!leaves(h)) return;
      leaving_.push_back(h);
      local_[h.value()] = HalfEdgeId(next);
      next += 2;
    });
    block_->border_count = next / 2;
    for_each_half_edge([&](HalfEdgeId h) {
      if (local_[h.value()].valid()) return;
      local_[h.value()] = HalfEdgeId(next);
      local_[Brep::twin(h).value()] = HalfEdgeId(next + 1);
      next += 2;
    });
    block_->brep().resize_half_edges(next);
  }
  /// Of the structure, per border edge of the block.
  const std::vector<HalfEdgeId>& leaving() const { return leaving_; }

  /// After number_edges().
  void fill();
  const std::shared_ptr<Block>& block() const { return block_; }

 private:
  template <class Visit>
  void for_each_half_edge(const Visit& visit) const {
    for (const FaceId f : faces_) for_each_in_face(brep_, f, visit);
  }
  std::vector<VertexId> number_vertices();
  /// About how many vertices there are: of triangles half as many as faces, of one face as many as
  /// edges.
  std::size_t expected_vertices() const {
    return std::max(faces_.size(), block_->brep().edge_count() / 2);
  }
  void reserve(std::size_t vertices);
  void add_faces(class GeometryLoader& geometry);
  void add_loop(LoopId loop, LoopId made);
  void add_vertices(const std::vector<VertexId>& vertices, GeometryLoader& geometry);
  void add_edge_planes(GeometryLoader& geometry);
  void add_touching_vertices(std::span<const VertexId> vertices);

  const Brep& brep_;
  const Geometry& geometry_;
  std::span<const FaceId> faces_;
  std::span<const VertexId> touching_;
  std::span<HalfEdgeId> local_;
  std::vector<HalfEdgeId> leaving_;
  std::shared_ptr<Block> block_ = std::make_shared<Block>();
};

}  // namespace sectile
