#include "storage/geometry_loader.h"

#include <utility>

namespace sectile {

PointId GeometryLoader::point(PointId p) {
  if (!p.valid()) return p;
  const std::uint32_t known = points_[p.value()];
  if (known != IdMap::none) return PointId(known);
  PointId made;
  if (from_.is_explicit(p)) {
    made = to_.add_point(from_.position(p));
  } else {
    const Construction& how = from_.construction(p);
    const Construction mine{plane(how.a), plane(how.b), plane(how.c), point(how.line_from),
                            point(how.line_to)};
    made = to_.add_point(mine, from_.position(p));
  }
  points_[p.value()] = made.value();
  return made;
}

PlaneId GeometryLoader::plane(PlaneId s, bool turned) {
  if (!s.valid()) return s;
  const std::uint32_t known = planes_[turned][s.value()];
  if (known != IdMap::none) return PlaneId(known);
  const PlaneId made = copy(from_.definition(s), turned);
  planes_[turned][s.value()] = made.value();
  return made;
}

namespace {

PlaneCoefficients negated(const PlaneCoefficients& k) {
  return {-k.a, -k.b, -k.c, -k.d};
}

// The same plane with the opposite normal, unless it has coefficients.
void turn(PlaneDefinition& how) {
  if (how.kind() == PlaneDefinition::Kind::three_points)
    std::swap(how.b, how.c);
  else
    std::swap(how.a, how.b);
}

}  // namespace

PlaneId GeometryLoader::copy(PlaneDefinition how, bool turned) {
  using Kind = PlaneDefinition::Kind;
  if (how.kind() == Kind::coefficients) {
    const PlaneCoefficients& k = from_.coefficients[how.a];
    return to_.add_plane(turned ? negated(k) : k);
  }
  how.a = point(PointId(how.a)).value();
  how.b = point(PointId(how.b)).value();
  if (how.kind() == Kind::three_points) how.c = point(PointId(how.c)).value();
  if (turned) turn(how);
  return to_.add_plane(how);
}

GeometryOffset append_geometry(const Geometry& from, Geometry& to, bool turned) {
  using Kind = PlaneDefinition::Kind;
  const GeometryOffset offset{static_cast<std::uint32_t>(to.positions.size()),
                              static_cast<std::uint32_t>(to.planes.size())};
  const auto constructions = static_cast<std::uint32_t>(to.constructions.size());
  const auto coefficients = static_cast<std::uint32_t>(to.coefficients.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  for (const PlaneCoefficients& k : from.coefficients)
    to.coefficients.push_back(turned ? negated(k) : k);
  for (const std::uint32_t c : from.construct)
    to.construct.push_back(c == Geometry::explicit_point ? c : c + constructions);
  for (const Construction& c : from.constructions)
    to.constructions.push_back({offset.plane(c.a), offset.plane(c.b), offset.plane(c.c),
                                offset.point(c.line_from), offset.point(c.line_to)});
  for (PlaneDefinition s : from.planes) {
    if (s.kind() == Kind::coefficients) {
      s.a += coefficients;
    } else {
      if (s.kind() == Kind::three_points) s.c += offset.points;
      s.a += offset.points;
      s.b += offset.points;
      if (turned) turn(s);
    }
    to.planes.push_back(s);
  }
  return offset;
}

}  // namespace sectile
