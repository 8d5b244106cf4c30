// The place of a point, if it is one.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "boolean/reduction/reduction.h"

namespace sectile {

class PlacesByPoint {
 public:
  PlacesByPoint(const Workspace& w, Contacts& found) : w_(w), found_(found) {
    for (const PlaceId place : found.places.ids()) add(place);
  }

  std::optional<PlaceId> find(PointId point) const {
    for (auto [at, last] = by_position_.equal_range(position(point)); at != last; ++at)
      if (w_.tests().same_point(found_.point(at->second), point)) return at->second;
    return {};
  }
  PlaceId find_or_add(PointId point) {
    if (const auto known = find(point)) return *known;
    const PlaceId place = found_.places.add(point);
    add(place);
    return place;
  }

 private:
  // Equal points have equal rounded positions.
  using Position = std::array<double, 3>;
  Position position(PointId point) const {
    const Vec3& p = w_.geometry.position(point);
    return {p.x, p.y, p.z};
  }
  void add(PlaceId place) { by_position_.emplace(position(found_.point(place)), place); }

  const Workspace& w_;
  Contacts& found_;
  std::multimap<Position, PlaceId> by_position_;
};

}  // namespace sectile
