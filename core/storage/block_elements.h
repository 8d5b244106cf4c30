// What is written of a block: of triangles that came in together as they came, without making their
// structure.
#pragma once

#include <cstdint>
#include <vector>

#include "storage/block.h"

namespace sectile {

/// Elements have their numbers in the block; half-edges run as they do there.
class BlockElements {
 public:
  explicit BlockElements(const Block& block)
      : block_(block), triangles_(block.compact_triangles()) {}

  /// None if the block was not made of triangles.
  const CompactTriangles* compact() const { return triangles_; }

  /// Calls visit(vertex, position, is_exact) for all vertices, ascending.
  template <class Visit>
  void each_vertex(const Visit& visit) const {
    if (triangles_ && !block_.is_image()) {
      for (std::uint32_t v = 0; v < triangles_->positions.size(); ++v)
        visit(v, triangles_->positions[v], true);
      return;
    }
    const Geometry& g = block_.geometry();
    const auto count = static_cast<std::uint32_t>(block_.vertex_count());
    for (std::uint32_t v = 0; v < count; ++v) {
      const PointId p = triangles_ ? PointId(v) : block_.brep().point_of(VertexId(v));
      visit(v, g.position(p), g.is_explicit(p));
    }
  }

  /// Calls visit(border edge, from, to) with the vertices of all edges that leave the block, as
  /// they run around its own faces.
  template <class Visit>
  void each_border_edge(const Visit& visit) const {
    if (!triangles_) {
      const Brep& brep = block_.brep();
      for (std::uint32_t b = 0; b < block_.border_count; ++b) {
        const HalfEdgeId h(2 * b);
        visit(b, brep.from(h).value(), brep.to(h).value());
      }
      return;
    }
    for (std::uint32_t b = 0; const auto& [corner, from, to] : triangles_->border)
      visit(b++, std::uint32_t(from), std::uint32_t(to));
  }

  /// Calls visit(vertex before, vertex, vertex after, is_of_triangle) for all corners of faces, as
  /// they run around them.
  template <class Visit>
  void each_corner(const Visit& visit) const {
    if (triangles_) {
      for (const auto& t : triangles_->triangles)
        for (std::size_t k = 0; k < 3; ++k)
          visit(std::uint32_t(t.vertex[k < 1 ? 2 : k - 1]), std::uint32_t(t.vertex[k]),
                std::uint32_t(t.vertex[k < 2 ? k + 1 : 0]), true);
      return;
    }
    const Brep& brep = block_.brep();
    for (const HalfEdgeId h : brep.half_edges()) {
      if (!brep.loop_of(h).valid()) continue;
      const HalfEdgeId last = brep.prev_of(h);
      visit(brep.from(last).value(), brep.from(h).value(), brep.to(h).value(),
            brep.next_of(brep.next_of(h)) == last);
    }
  }

  /// Per border edge: the face that it belongs to.
  std::vector<FaceId> faces_at_border() const {
    std::vector<FaceId> faces(block_.border_count);
    for (std::uint32_t b = 0; b < faces.size(); ++b)
      faces[b] = triangles_ ? FaceId(triangles_->border[b].corner / 3u)
                            : block_.brep().face_of(HalfEdgeId(2 * b));
    return faces;
  }

 private:
  const Block& block_;
  const CompactTriangles* triangles_;
};

}  // namespace sectile
