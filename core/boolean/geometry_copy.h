// Copies the points and planes that a result needs, each once, with planes turned on demand.
#pragma once

#include <vector>

#include "geometry/geometry.h"

namespace sectile {

class GeometryCopy {
 public:
  GeometryCopy(const Geometry& from, Geometry& to)
      : from_(from), to_(to), points_(from.positions.size()), planes_(from.planes.size()) {}

  PointId point(PointId p);
  PlaneId plane(PlaneId s);
  /// The same plane with the opposite normal.
  PlaneId turned(PlaneId s);

 private:
  PlaneDefinition definition(PlaneId s);

  const Geometry& from_;
  Geometry& to_;
  std::vector<PointId> points_;
  std::vector<PlaneId> planes_, turned_;
};

}  // namespace sectile
