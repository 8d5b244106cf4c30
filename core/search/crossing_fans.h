// Fans around points through which very many edges run (search/edge_crossings.h).
//
//      \ | /      Seen from such a point a face that has it within an edge covers half a turn, and
//     --\|/--     what passes it covers an arc, too, if it is thin. Two faces that have more in
//       /|\       common than the point are seen in a common direction, so that all that is long
//      / | \      beside its distance from the point is in the fan, whether it has the point or
//      not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/seen_arc.h"
#include "search/sided_polygons.h"

namespace sectile {

class CrossingFans {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  CrossingFans() = default;
  CrossingFans(const Kernel& kernel, const SidedPolygons& polygons);

  std::size_t count() const { return fans_.size(); }
  /// Per polygon: its fan, or none. Empty if there is no fan.
  const std::vector<std::uint32_t>& of_polygon() const { return of_polygon_; }
  /// Ascending.
  std::span<const std::uint32_t> polygons(std::size_t fan) const { return fans_[fan].polygons; }
  /// How the point sees each of them. Two have nothing but the point in common, and not within
  /// either, if their arcs do not meet.
  std::span<const SeenArc> arcs(std::size_t fan) const { return fans_[fan].arcs; }
  /// All polygons that have the point in an edge or a corner, ascending, maybe some of other fans.
  std::span<const std::uint32_t> at_point(std::size_t fan) const { return fans_[fan].at_point; }
  /// Of what is in the geometry that was given.
  const Construction& how(std::size_t fan) const { return fans_[fan].how; }
  /// The points are in a geometry of their own, which has all of the one that was given.
  PointId point(std::size_t fan) const { return fans_[fan].point; }
  const Geometry& geometry() const { return geometry_; }

 private:
  struct Fan {
    Construction how;
    PointId point;
    std::vector<std::uint32_t> polygons, at_point;
    std::vector<SeenArc> arcs;
  };

  void add_polygons(const SidedPolygons& polygons);
  void leave_out_small_ones();

  Geometry geometry_;
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> of_polygon_;
};

}  // namespace sectile
