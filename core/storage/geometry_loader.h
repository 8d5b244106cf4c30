// Copies points and planes from one geometry to another: those that are asked for, each once, or
// all.
#pragma once

#include <optional>

#include "geometry/geometry.h"
#include "search/id_map.h"

namespace sectile {

class GeometryLoader {
 public:
  /// `expected`: about how many points there will be.
  GeometryLoader(const Geometry& from, Geometry& to, std::size_t expected)
      : from_(from), to_(to), expected_(expected), points_(expected, from.positions.size()) {}

  PointId point(PointId p) {
    if (!p.valid()) return p;
    const std::uint32_t known = points_[p.value()];
    return known != IdMap::none ? PointId(known) : load(p);
  }
  /// `turned`: with the opposite normal.
  PlaneId plane(PlaneId s, bool turned = false) { return s.valid() ? plane_of(s, turned) : s; }
  /// A plane that is there already, by another number.
  void set_plane(PlaneId from, PlaneId to);
  /// Those that were asked for before; may be called from many threads.
  PointId known(PointId p) const { return p.valid() ? PointId(points_.known(p.value())) : p; }
  PlaneId known(PlaneId s, bool turned) const {
    return s.valid() ? PlaneId(planes_[turned]->known(s.value())) : s;
  }

 private:
  PointId load(PointId p);
  PlaneId plane_of(PlaneId s, bool turned);
  PlaneId copy(PlaneDefinition how, bool turned);
  std::uint32_t frame(std::uint32_t f);
  std::uint32_t direction(std::uint32_t d);

  const Geometry& from_;
  Geometry& to_;
  std::size_t expected_;
  IdMap points_;
  // None until the first is asked for.
  std::optional<IdMap> planes_[2];  // as they are, and turned
  std::optional<IdMap> frames_, directions_;
};

/// Adds the plane with the opposite normal.
PlaneId add_turned_plane(Geometry& geometry, PlaneId s);

/// All of a geometry, with room for what is added from another one.
void copy_with_room(const Geometry& from, const Geometry& more, Geometry& to);

/// What was added to the numbers of points and planes.
struct GeometryOffset {
  std::uint32_t points = 0, planes = 0;
  PointId point(PointId p) const { return p.valid() ? PointId(p.value() + points) : p; }
  PlaneId plane(PlaneId s) const { return s.valid() ? PlaneId(s.value() + planes) : s; }
};
/// Copies all tables at once, behind what there is. `turned`: all planes with the opposite normal.
GeometryOffset append_geometry(const Geometry& from, Geometry& to, bool turned = false);

}  // namespace sectile
