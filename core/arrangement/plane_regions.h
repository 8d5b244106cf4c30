// The regions into which the edges of an arrangement divide a plane.
#pragma once

#include "arrangement/plane_pieces.h"

namespace sectile::arrangement {

/// Regions that are covered by at least one face. Seen against the normal of the plane, outer loops
/// run counter-clockwise.
struct Regions {
  std::vector<PointId> corners;
  std::vector<PlaneId> across;     ///< per corner: a plane through the edge that leaves it
  std::vector<std::uint32_t> row;  ///< per corner: that of the edge
  std::vector<std::uint32_t> loop_end;
  std::vector<std::uint32_t> region_end;  ///< end of each region's loops, the outer one first
  std::vector<std::uint32_t> cover_end;
  std::vector<std::uint32_t> cover;  ///< the faces that cover each region, ascending

  std::span<const std::uint32_t> cover_of(std::size_t region) const {
    const std::uint32_t begin = region > 0 ? cover_end[region - 1] : 0;
    return std::span(cover).subspan(begin, cover_end[region] - begin);
  }
};

Regions find_regions(const PlanePieces& pieces, const Kernel& kernel);

}  // namespace sectile::arrangement
