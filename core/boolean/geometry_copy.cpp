#include "boolean/geometry_copy.h"

#include <utility>

namespace sectile {

using Kind = PlaneDefinition::Kind;

PointId GeometryCopy::point(PointId p) {
  if (!p.valid()) return p;
  if (points_[p.value()].valid()) return points_[p.value()];
  PointId made;
  if (from_.is_explicit(p)) {
    made = to_.add_point(from_.position(p));
  } else {
    const Construction& how = from_.construction(p);
    const Construction mine{plane(how.a), plane(how.b), plane(how.c), point(how.line_from),
                            point(how.line_to)};
    made = to_.add_point(mine, from_.position(p));
  }
  return points_[p.value()] = made;
}

PlaneDefinition GeometryCopy::definition(PlaneId s) {
  PlaneDefinition how = from_.definition(s);
  if (how.kind() == Kind::coefficients) return how;
  how.a = point(PointId(how.a)).value();
  how.b = point(PointId(how.b)).value();
  if (how.kind() == Kind::three_points) how.c = point(PointId(how.c)).value();
  return how;
}

PlaneId GeometryCopy::plane(PlaneId s) {
  if (planes_[s.value()].valid()) return planes_[s.value()];
  const PlaneDefinition how = definition(s);
  return planes_[s.value()] = how.kind() == Kind::coefficients
                                  ? to_.add_plane(from_.coefficients[how.a])
                                  : to_.add_plane(how);
}

PlaneId GeometryCopy::turned(PlaneId s) {
  if (turned_.empty()) turned_.resize(from_.planes.size());
  if (turned_[s.value()].valid()) return turned_[s.value()];
  PlaneDefinition how = definition(s);
  PlaneId made;
  if (how.kind() == Kind::coefficients) {
    const PlaneCoefficients& k = from_.coefficients[how.a];
    made = to_.add_plane(PlaneCoefficients{-k.a, -k.b, -k.c, -k.d});
  } else {
    if (how.kind() == Kind::three_points)
      std::swap(how.b, how.c);
    else
      std::swap(how.a, how.b);
    made = to_.add_plane(how);
  }
  return turned_[s.value()] = made;
}

}  // namespace sectile
