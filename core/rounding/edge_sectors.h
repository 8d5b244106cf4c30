// Around an edge along which wedges of material touch: sectors that have no inside in common.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// All that is around an edge is divided twice: within the gaps, into sectors with one wedge each,
/// and within the wedges, into sectors with one gap each. So a wedge is well within its sector, and
/// what rounding has bent is so as well; and what goes from wall to wall, as a floor between them
/// does, is in a sector, too.
class EdgeSectors {
 public:
  /// A face of a wedge at the edge, and the corner of it that is beside the edge.
  struct Side {
    std::uint32_t face;  ///< the caller's number
    PlaneId plane;
    PointId beside;
  };
  /// The first side, seen from outside, lies to the left of one who goes along the edge from its
  /// first end to the other one.
  struct Wedge {
    Side left, right;
  };
  /// Adds to the geometry, which is the kernel's.
  EdgeSectors(PointId from, PointId to, std::span<const Wedge> wedges, Geometry& geometry,
              Kernel& kernel);

  /// The wedges, as they come around the edge. None if material does not alternate with the
  /// outside.
  std::span<const std::uint32_t> order() const { return order_; }
  struct Sector {
    std::vector<PlaneId> planes;  ///< all of it is below them; none if it is half of space or more
    std::array<std::uint32_t, 2> faces;  ///< that bound the wedge, or the gap
  };
  /// In the same order: of a wedge, and of the gap after it.
  const Sector& of_wedge(std::size_t i) const { return of_wedges_[i]; }
  const Sector& of_gap(std::size_t i) const { return of_gaps_[i]; }

  /// Have two of these sectors no inside in common? Those of n wedges are numbered from 0, those of
  /// gaps from n.
  static bool are_apart(std::size_t n, std::size_t a, std::size_t b);

 private:
  bool sort(std::span<const Wedge> wedges);
  void find_rays();
  Vec3 place_amid(const Side& first, const Side& last) const;
  Sector sector(PointId first, PointId last, const Side& first_side, const Side& last_side);
  std::vector<PlaneId> planes_between(PointId first, PointId last);
  std::size_t after(std::size_t i) const { return i + 1 < order_.size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return (i > 0 ? i : order_.size()) - 1; }

  Geometry& geometry_;
  Kernel& kernel_;
  PointId from_, to_;  // upwards
  std::vector<std::uint32_t> order_;
  std::vector<Wedge> wedges_;               // in that order, seen by one who goes upwards
  std::vector<PointId> in_wedge_, in_gap_;  // a point there, if doubles find one
  std::vector<Sector> of_wedges_, of_gaps_;
};

}  // namespace sectile
