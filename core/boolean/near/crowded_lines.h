// Lines along which very many edges of both solids run, each with ends of its own: the spines of
// two books of which no two pages are of one length.
//
// Around such a line all boxes overlap, and each edge ends within all others. But two faces that
// leave the line in different directions meet in nothing but the line. Does that matter? A walk
// around a vertex of A on the line and one around a vertex of B there cross evenly often. So if
// none of their faces meet off the line, then nowhere along it does the surface of one lead from
// one side of the other's to its other side: neither has to be cut there, and what one is to the
// other is the same on all of it. What the edges share is a row (reduction/rows_on_lines.h): it
// has all of them, whatever meets.
//
// Where no row can be made, wedges of material that have a direction in common are in pairs, as a
// result has edges of both there; what hangs together by no pair is a cluster of its own
// (reduction/clusters.h). That does not do where the edges of a solid bound the wedges between its
// material, as it is to be turned inside out: a wedge that holds an edge may be bounded by any of
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"
#include "search/hull.h"
#include "search/spine_lines.h"
#include "storage/solid_data.h"

namespace sectile {

class CrowdedLines {
 public:
  /// Of the blocks in some slots of each solid. The edges of b may bound wedges without material:
  /// then there are no pairs of wedges.
  CrowdedLines(const SolidData& a, const SolidData& b,
               const PerOperand<std::span<const std::uint32_t>>& slots, bool turned_pairs_of_b);

  bool empty() const { return lines_.count() == 0; }
  /// All pairs of faces of the solids that may meet, but for those that matter nowhere.
  FacePairs pairs();
  /// The faces at the lines. Rays must not begin in what they have on them.
  PerOperand<std::vector<FaceId>> faces() const;
  /// Adds the lines to the workspace, and marks the vertices on them, and maybe some beside them,
  /// in its patches with these faces.
  void mark(Workspace& w) const;

 private:
  static constexpr std::uint32_t none = SpineLines::none;

  struct Face {
    Operand solid;
    std::uint32_t slot;
    FaceId face;                // of the block
    std::uint32_t first, last;  // of its sides
    std::uint32_t line = none;  // on which most of its corners are
  };
  /// A half-edge of a block.
  struct Side {
    HalfEdgeId h;
    PointId from, to;
  };
  /// What two faces bound at an edge on their line.
  struct Wedge {
    std::uint32_t face[2];
    Box box;
  };

  void add_faces(Operand s, std::uint32_t slot);
  void find_lines(const Kernel& kernel);
  bool is_on(PointId p, std::uint32_t line) const;

  void add_pairs_off_lines(FacePairs& pairs);
  void add_pairs_along(std::uint32_t line, const PerOperand<std::vector<std::uint32_t>>& faces,
                       FacePairs& pairs) const;
  void add_wedge_pairs(std::uint32_t line, const PerOperand<std::vector<std::uint32_t>>& faces,
                       FacePairs& pairs) const;
  std::vector<Wedge> wedges(std::uint32_t line, const std::vector<std::uint32_t>& faces) const;
  Box box_of_wedge(std::uint32_t line, std::uint32_t face, const Side& side,
                   std::uint32_t beyond) const;
  void mark_vertices(Workspace& w) const;
  void sort_corners(std::uint32_t line, std::uint32_t face, std::vector<Vec3>& on_line,
                    std::vector<Vec3>& beside) const;
  /// None if its block is not near.
  std::uint32_t face_beyond(const Face& face, HalfEdgeId h) const;

  bool are_apart(std::uint32_t f, std::uint32_t g);
  const Hull& hull(std::uint32_t face);
  const Block& block(const Face& f) const { return *data_[f.solid]->slot(f.slot).block; }
  FaceId in_solid(std::uint32_t face) const {
    const Face& f = faces_[face];
    return data_[f.solid]->face(f.slot, f.face);
  }
  std::span<const Side> sides(const Face& f) const {
    return std::span(sides_).subspan(f.first, f.last - f.first);
  }
  const Vec3& at(PointId p) const { return geometry_.position(p); }

  PerOperand<const SolidData*> data_;
  bool turned_pairs_of_b_;
  Geometry geometry_;                                  // of both
  std::vector<Face> faces_;                            // those of A first
  std::vector<Side> sides_;                            // by face
  PerOperand<std::vector<std::uint32_t>> first_face_;  // per slot that is near
  SpineLines lines_;
  std::vector<std::optional<Hull>> hulls_;  // of faces that were asked for
};

}  // namespace sectile
