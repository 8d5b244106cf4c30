// What divides a plane: the edges of faces in it, and the traces of faces of other planes.
#pragma once

#include <vector>

#include "arrangement/row_lines.h"

namespace sectile::arrangement {

/// A piece of a line in the plane. The edge of a face has the number of its corner.
struct Piece {
  PointId from, to;
  PlaneId across;
  std::uint32_t corner = none;
  std::uint32_t row = none;  ///< of the lines along which edges stay whole, the one on which it is
};

/// Part of a piece, between two places and without one within it.
struct PlaneEdge {
  PointId low, high;  ///< low < high
  PlaneId across;
  /// The edges of faces that lie on it.
  struct Border {
    std::uint32_t face;
    bool forward;  ///< runs from low to high
    friend auto operator<=>(const Border&, const Border&) = default;
  };
  std::uint32_t first_border = 0, border_end = 0;
  std::uint32_t row = none;
};

/// The pieces of one group of faces that overlap in one plane.
class PlanePieces {
 public:
  PlanePieces() = default;
  PlanePieces(const Facets& facets, const EdgeLines& lines, const Traces& traces,
              const RowLines& rows, std::span<const std::uint32_t> faces, const Kernel& kernel);

  /// Finds where pieces cross, and which ends and points lie within pieces.
  void find_crossings(const Kernel& kernel, const EdgeLines& lines);
  const std::vector<Construction>& constructions() const { return constructions_; }

  /// Divides the pieces; `made` are the points of the constructions.
  void divide(const Kernel& kernel, std::span<const PointId> made,
              std::span<const PointId> first_at, const Facets& facets);

  PlaneId plane() const { return plane_; }
  const std::vector<PlaneEdge>& edges() const { return edges_; }
  std::span<const PlaneEdge::Border> borders(const PlaneEdge& e) const {
    return std::span(borders_).subspan(e.first_border, e.border_end - e.first_border);
  }

 private:
  void test(const Kernel& kernel, const EdgeLines& lines, std::uint32_t i, std::uint32_t j);

  struct Incidence {
    std::uint32_t piece;
    PointId point;
    std::uint32_t made = none;
  };

  PlaneId plane_;
  std::vector<Piece> pieces_;  // then the points, as pieces without length
  std::vector<Incidence> incidences_;
  std::vector<Construction> constructions_;
  std::vector<PlaneEdge> edges_;
  std::vector<PlaneEdge::Border> borders_;
};

}  // namespace sectile::arrangement
