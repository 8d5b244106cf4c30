// The faces that are to be arranged, in one geometry: those of a soup, or of several solids.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "arrangement/steering.h"
#include "import/polygons.h"
#include "storage/solid_data.h"

namespace sectile::arrangement {

inline constexpr std::uint32_t none = 0xFFFFFFFFu;

/// Plane faces. A corner stands for the half-edge that leaves it.
struct Facets {
  Polygons polygons;                   ///< corners at one place are one point; `source` is not used
  std::vector<PlaneId> plane;          ///< per face
  std::vector<FaceSource> source;      ///< per face
  std::vector<std::uint32_t> operand;  ///< per face: the solid to whose boundary it belongs
  /// Per corner: a plane through the edge that is not parallel to the face's, if one is known; it
  /// must be where an end of the edge is constructed. Empty if none is known.
  std::vector<PlaneId> second_plane;

  std::vector<std::uint32_t> face_of;  ///< per corner
  std::vector<std::uint32_t> next;     ///< per corner: the next one of its loop

  std::size_t face_count() const { return polygons.face_count(); }
  std::uint32_t begin(std::size_t f) const { return polygons.loop_begin(polygons.first_loop(f)); }
  std::uint32_t end(std::size_t f) const { return polygons.loop_end[polygons.face_end[f] - 1]; }
  std::uint32_t size(std::size_t f) const { return end(f) - begin(f); }
  PointId from(std::uint32_t corner) const { return polygons.corners[corner]; }
  PointId to(std::uint32_t corner) const { return polygons.corners[next[corner]]; }

  /// Fills face_of and next.
  void link();
};

/// Puts the least of the points at the same place, among those given, into first[point] of each.
/// `first` is made longer if need be; new entries are the points themselves.
void unite_places(const Kernel& kernel, std::vector<PointId> points, std::vector<PointId>& first);

/// The boundaries of several solids, which become the operands 0, 1 …; their points and planes are
/// added to the geometry.
Facets facets_of(std::span<const Solid> solids, Geometry& geometry, const Steering& steering);

}  // namespace sectile::arrangement
