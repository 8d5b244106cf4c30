// Lines along which very many edges of both solids run, each with ends of its own: the spines of
// two books of which no two pages are of one length.
//
// Around such a line all boxes overlap, and each edge ends within all others. But two faces that
// leave the line in different directions meet in nothing but the line, and what both solids have on
// it is a row, whether pairs of faces have found it or not (reduction/rows_on_lines.h). So such
// pairs are left out. So are pairs of faces at two such lines that meet in nothing but the crossing
// of the lines (line_crossings.h): no segment ends there for them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boolean/near/faces_at_crossings.h"
#include "boolean/near/line_crossings.h"
#include "boolean/reduction/reduction.h"
#include "search/hubs.h"
#include "search/hull.h"
#include "search/spine_lines.h"
#include "storage/solid_data.h"

namespace sectile {

class CrowdedLines {
 public:
  /// So many edges run beside each on the average: fewer take no longer with all pairs.
  static constexpr std::size_t many_beside = 2 * Hubs::least_faces;

  /// Of the blocks in some slots of each solid.
  CrowdedLines(const SolidData& a, const SolidData& b,
               const PerOperand<std::span<const std::uint32_t>>& slots);

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

  void add_faces(Operand s, std::uint32_t slot);
  void find_lines(const Kernel& kernel);
  void find_crossings(Kernel& kernel);
  bool has_edge_on_line(const Face& face) const;
  PlaneId load_plane(const Face& face);
  bool is_on(PointId p, std::uint32_t line) const;

  void add_pairs_elsewhere(FacesAtCrossings& at_crossings, FacePairs& pairs);
  void add_pairs_at(const LineCrossing& crossing, const FacesAtCrossings::OfLines& faces,
                    unsigned line_of_a, FacePairs& pairs);
  std::vector<Box> boxes_at(const LineCrossing& crossing, unsigned own,
                            std::span<const std::uint32_t> faces) const;
  void add_unless_apart(std::uint32_t f, std::uint32_t g, FacePairs& pairs);
  void add_pairs_along(std::uint32_t line, const PerOperand<std::vector<std::uint32_t>>& faces,
                       FacePairs& pairs) const;
  void mark_vertices(Workspace& w) const;
  void sort_corners(std::uint32_t line, std::uint32_t face, std::vector<Vec3>& on_line,
                    std::vector<Vec3>& beside) const;

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
  Geometry geometry_;        // of both
  std::vector<Face> faces_;  // those of A first
  std::vector<Side> sides_;  // by face
  SpineLines lines_;
  std::vector<LineCrossing> crossings_;
  std::vector<std::optional<Hull>> hulls_;  // of faces that were asked for
};

}  // namespace sectile
