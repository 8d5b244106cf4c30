// A block: some neighbouring faces of a boundary, with points and planes of their own. Solids share
// blocks; a block never changes once it is in a solid.
//
// Its half-edge structure is that of a solid (topology/brep.h), but for the edges that leave the
// block. They come first, edges 0 … border_count - 1: the even half-edge belongs to a face of the
// block; the odd one has no loop and stands for a half-edge of a neighbouring block, which has the
// same edge among its own. Who the neighbour is depends on the solid and is said by the slot.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/geometry.h"
#include "geometry/moved_geometry.h"
#include "parallel/once_alone.h"
#include "search/face_tree.h"
#include "search/oriented_box.h"
#include "storage/block_measure.h"
#include "storage/compact_triangles.h"
#include "storage/pieces.h"
#include "topology/brep.h"

namespace sectile {

class Block {
 public:
  /// To be filled through brep() and geometry() before anyone else sees it.
  Block();
  /// Its structure and geometry are made when they are first asked for. No two vertices may be at
  /// one point, also beyond the block.
  explicit Block(CompactTriangles triangles);
  /// The image of a block: its faces, with other points and planes of the same numbers, which are
  /// made when they are first asked for.
  Block(std::shared_ptr<const Block> original, std::shared_ptr<const GeometryMover> mover);
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  std::uint32_t border_count = 0;

  /// Of a block that is being made.
  Brep& brep() { return structure_->brep; }
  const Brep& brep() const {
    if (structure_->is_late && !structure_->once.done()) structure_->make();
    return structure_->brep;
  }
  /// Of a block that is being made.
  Geometry& geometry() { return geometry_; }
  const Geometry& geometry() const {
    if (is_late_ && !geometry_once_.done()) make_geometry();
    return geometry_;
  }

  // Known without a structure.
  bool has_structure() const { return !structure_->is_late || structure_->once.done(); }
  /// Of what the structure is made, or will be: none if it was not made of triangles.
  const CompactTriangles* compact_triangles() const { return structure_->triangles.get(); }
  /// Are its points the images of those of another block?
  bool is_image() const { return is_image_; }
  std::size_t face_count() const;
  std::size_t half_edge_count() const;
  std::size_t loop_count() const;
  std::size_t vertex_count() const;

  /// Calls visit(FaceSource) for each face. Makes no structure.
  template <class Visit>
  void for_each_source(const Visit& visit) const {
    const auto of_triangles = [&] {
      const CompactTriangles& made_of = *structure_->triangles;
      for (const auto& triangle : made_of.triangles)
        visit(FaceSource{made_of.origin, triangle.source});
    };
    if (structure_->is_late && structure_->once.run_before(of_triangles)) return;
    for (const FaceSource& source : structure_->brep.source) visit(source);
  }

  void set_touching_vertices(std::vector<VertexId> vertices);
  void set_bounds(const Box& bounds);

  bool is_border(EdgeId e) const { return e.value() < border_count; }
  bool is_border(HalfEdgeId h) const { return h.value() < 2 * border_count; }

  // Found when first asked for, and then kept.
  const FaceTree& tree() const;
  bool has_tree() const { return tree_once_.done(); }
  const Pieces& pieces() const;
  /// That of a half-edge's face.
  std::uint32_t piece_at(HalfEdgeId h) const {
    return pieces().count() == 1 ? 0 : pieces().of(brep().face_of(h));
  }
  /// Where the solid touches itself, or did before it was cut: see topology/touching_vertices.h.
  const std::vector<VertexId>& touching_vertices() const;
  /// Of all corners; around an image more loosely.
  const Box& bounds() const;
  // Not for a block without faces.
  /// As they lie.
  const OrientedBox& oriented_bounds() const;
  const BlockVolume& volume() const;
  const Bounded& two_areas() const;

 private:
  // Images share it with those from which they come.
  struct Structure {
    Brep brep;
    bool is_late = false;  // made of triangles, when it is first asked for
    OnceFlag once;
    std::shared_ptr<const CompactTriangles> triangles;  // of which it is made; written from
    // Of what is late.
    std::uint32_t faces = 0, half_edges = 0, vertices = 0;
    OnceFlag pieces_once;
    Pieces pieces;

    void make();
  };
  void make_geometry() const;

  std::shared_ptr<Structure> structure_;
  mutable Geometry geometry_;
  bool is_late_ = false, is_image_ = false;
  // Of what the geometry is made, until it is: of triangles, or as the image of another.
  mutable std::shared_ptr<const CompactTriangles> triangles_;
  mutable std::shared_ptr<const Block> original_;
  mutable std::shared_ptr<const GeometryMover> mover_;
  mutable OnceFlag geometry_once_, tree_once_, touching_once_, bounds_once_, oriented_once_,
      volume_once_, area_once_;
  mutable std::unique_ptr<FaceTree> tree_;
  mutable std::vector<VertexId> touching_vertices_;
  mutable Box bounds_;
  mutable std::unique_ptr<OrientedBox> oriented_bounds_;
  mutable BlockVolume volume_;
  mutable Bounded two_areas_;
};

}  // namespace sectile
