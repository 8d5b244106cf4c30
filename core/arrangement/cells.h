// The cells into which the faces of an arrangement divide space, with their winding numbers.
#pragma once

#include "arrangement/edge_rows.h"

namespace sectile::arrangement {

/// The sub-faces around one edge, counter-clockwise; those that are simply neighbours are not here.
struct EdgeFan {
  struct Side {
    std::uint32_t corner;
    bool forward;  ///< what is before the sub-face comes after it
  };
  std::uint32_t first, end;
};

struct Cells {
  /// Per corner: the corner of the only other sub-face at the edge, or none.
  std::vector<std::uint32_t> mate;
  std::vector<EdgeFan> fans;
  std::vector<EdgeFan::Side> sides;
  std::vector<EdgeRow> rows;           ///< of the edges that belong to rows; they have no mates
  std::vector<std::uint32_t> face_of;  ///< per corner: the sub-face

  /// Per sub-face: the cell that its normal points to, and the one behind it.
  std::vector<std::uint32_t> before, behind;
  std::vector<Winding> winding;  ///< per cell
  /// How many parts were turned around because they were inside out, with a face of each.
  std::vector<std::uint32_t> turned;

  std::span<const EdgeFan::Side> of(const EdgeFan& fan) const {
    return std::span(sides).subspan(fan.first, fan.end - fan.first);
  }
};

/// What is to be done with parts around which there is nothing and that go around nothing but
/// negative winding numbers. Turned, they are counted as if all faces in them were turned around.
enum class InsideOut { keep, turn };

/// Throws InternalError if the winding numbers contradict each other: the faces were not closed.
Cells find_cells(const SubFaces& faces, const Facets& facets, const BoxTree& tree,
                 Counting counting, InsideOut inside_out, const Kernel& kernel,
                 const Steering& steering);

}  // namespace sectile::arrangement
