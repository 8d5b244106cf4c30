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
#include "topology/brep.h"

namespace sectile {

/// The faces of a block that hang together over its edges.
struct Pieces {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

class Block {
  std::shared_ptr<Brep> shared_brep_;

 public:
  Block() : shared_brep_(std::make_shared<Brep>()), brep(*shared_brep_) {}
  /// The image of a block: its faces, with other points and planes of the same numbers, which are
  /// made when they are first asked for.
  Block(std::shared_ptr<const Block> original, std::shared_ptr<const GeometryMover> mover);
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  Brep& brep;  ///< images share it with those from which they come
  std::uint32_t border_count = 0;

  /// Of a block that is being made.
  Geometry& geometry() { return geometry_; }
  const Geometry& geometry() const {
    if (is_image_) make_image();
    return geometry_;
  }

  void set_touching_vertices(std::vector<VertexId> vertices);

  bool is_border(EdgeId e) const { return e.value() < border_count; }
  bool is_border(HalfEdgeId h) const { return h.value() < 2 * border_count; }

  // Found when first asked for, and then kept.
  const FaceTree& tree() const;
  const Pieces& pieces() const;
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
  void make_image() const;

  mutable Geometry geometry_;
  bool is_image_ = false;
  // Of an image, until its points are made.
  mutable std::shared_ptr<const Block> original_;
  mutable std::shared_ptr<const GeometryMover> mover_;
  mutable OnceFlag image_once_, tree_once_, pieces_once_, touching_once_, bounds_once_,
      oriented_once_, volume_once_, area_once_;
  mutable std::unique_ptr<FaceTree> tree_;
  mutable Pieces pieces_;
  mutable std::vector<VertexId> touching_vertices_;
  mutable Box bounds_;
  mutable std::unique_ptr<OrientedBox> oriented_bounds_;
  mutable BlockVolume volume_;
  mutable Bounded two_areas_;
};

}  // namespace sectile
