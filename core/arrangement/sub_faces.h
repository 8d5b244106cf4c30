// The faces of an arrangement: parts of faces that meet only in common edges and corners.
#pragma once

#include "arrangement/facet_tree.h"
#include "arrangement/pairs.h"
#include "arrangement/steering.h"
#include "arrangement/winding.h"

namespace sectile::arrangement {

/// Faces that lie on each other are one.
struct SubFaces {
  Polygons polygons;           ///< counter-clockwise, seen against the normal of the plane
  std::vector<PlaneId> plane;  ///< per sub-face
  /// Per corner: a plane through the edge, not parallel to the face's, where one is known.
  std::vector<PlaneId> across;
  /// Per corner: the row to which the edge belongs, or none. Empty if there are no rows.
  std::vector<std::uint32_t> row;
  std::vector<std::uint32_t> cover_end;
  std::vector<std::uint32_t> cover;    ///< the faces that lie there, ascending
  std::vector<std::uint8_t> divided;   ///< per sub-face: was found by dividing a plane
  std::vector<std::uint32_t> step_of;  ///< per sub-face: in steps
  std::vector<Winding> steps;  ///< what is behind a sub-face has more than what is before it

  /// How many faces were divided, at how many places several lie on each other, and the first ones.
  std::size_t divided_faces = 0, overlaps = 0;
  std::uint32_t first_divided = none, first_overlap = none;

  std::size_t size() const { return plane.size(); }
  std::span<const std::uint32_t> cover_of(std::size_t f) const {
    const std::uint32_t begin = f > 0 ? cover_end[f - 1] : 0;
    return std::span(cover).subspan(begin, cover_end[f] - begin);
  }
};

/// Adds the points in which faces meet to the geometry. Parts whose faces cancel each other are
/// left out.
SubFaces arrange(const Facets& facets, const FacetTree& tree, Counting counting, Crowds crowds,
                 Geometry& geometry, Kernel& kernel, const Steering& steering);

}  // namespace sectile::arrangement
