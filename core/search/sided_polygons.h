// Polygons with what is beyond their sides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numbers/id.h"

namespace sectile {

/// One side after the other around each polygon, and around each of its holes.
class SidedPolygons {
 public:
  struct Side {
    PointId from, to;
    PlaneId beyond;  ///< the plane of what is on the other side of it, or none
  };

  void add_side(PointId from, PointId to, PlaneId beyond) { sides_.push_back({from, to, beyond}); }
  /// Those that were added since the last one; of two with one label there is no pair.
  void end_polygon(PlaneId plane, std::uint32_t label) {
    planes_.push_back(plane);
    labels_.push_back(label);
    ends_.push_back(static_cast<std::uint32_t>(sides_.size()));
  }

  std::size_t count() const { return planes_.size(); }
  std::span<const Side> sides(std::size_t polygon) const {
    const std::size_t from = polygon == 0 ? 0 : ends_[polygon - 1];
    return std::span(sides_).subspan(from, ends_[polygon] - from);
  }
  PlaneId plane(std::size_t polygon) const { return planes_[polygon]; }
  /// May these two be a pair?
  bool may_meet(std::size_t polygon, std::size_t other) const {
    return labels_[polygon] == no_label || labels_[polygon] != labels_[other];
  }
  static constexpr std::uint32_t no_label = 0xFFFFFFFFu;

 private:
  std::vector<Side> sides_;
  std::vector<PlaneId> planes_;
  std::vector<std::uint32_t> labels_, ends_;
};

}  // namespace sectile
