#include "storage/geometry_loader.h"

#include <utility>

#include "numbers/threshold.h"

namespace sectile {
namespace {

IdMap& made(std::optional<IdMap>& map, std::size_t expected, std::size_t ids) {
  if (!map) map.emplace(expected, ids);
  return *map;
}

constexpr std::size_t few_frames =
    threshold(16, 1);  // as a rule, of faces that are near each other

}  // namespace

std::uint32_t GeometryLoader::frame(std::uint32_t f) {
  std::uint32_t& known = made(frames_, few_frames, from_.frames.size())[f];
  if (known == IdMap::none) known = to_.frames.place(from_.frames[f]);
  return known;
}

std::uint32_t GeometryLoader::direction(std::uint32_t d) {
  std::uint32_t& known = made(directions_, few_frames, from_.directions.size())[d];
  if (known == IdMap::none) known = to_.directions.place(from_.directions[d]);
  return known;
}

PointId GeometryLoader::load(PointId p) {
  PointId made;
  if (from_.is_explicit(p)) {
    made = to_.add_point(from_.position(p));
  } else if (from_.is_moved(p)) {
    const MovedPoint& how = from_.moved_point_of(p);
    made = to_.add_point(MovedPoint{how.local, frame(how.frame)}, from_.position(p));
  } else {
    const Construction& how = from_.construction(p);
    const Construction mine{plane(how.a), plane(how.b), plane(how.c), point(how.line_from),
                            point(how.line_to)};
    made = to_.add_point(mine, from_.position(p));
  }
  points_[p.value()] = made.value();
  return made;
}

PlaneId GeometryLoader::plane_of(PlaneId s, bool turned) {
  IdMap& planes = made(planes_[turned], expected_, from_.planes.size());
  const std::uint32_t known = planes[s.value()];
  if (known != IdMap::none) return PlaneId(known);
  const PlaneId copied = copy(from_.definition(s), turned);
  planes[s.value()] = copied.value();
  return copied;
}

void GeometryLoader::set_plane(PlaneId from, PlaneId to) {
  made(planes_[0], expected_, from_.planes.size())[from.value()] = to.value();
}

namespace {

PlaneCoefficients negated(const PlaneCoefficients& k) {
  return {-k.a, -k.b, -k.c, -k.d};
}
std::shared_ptr<const ExactCoefficients> negated(const ExactCoefficients& k) {
  auto made = std::make_shared<ExactCoefficients>();
  for (int i = 0; i < 3; ++i) made->n[i] = ExactNumber(-k.n[i].exact());
  made->d = ExactNumber(-k.d.exact());
  return made;
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
  if (how.kind() == Kind::exact_coefficients) {
    const auto& k = from_.exact_coefficients[how.a];
    to_.exact_coefficients.push_back(turned ? negated(*k) : k);
    return to_.add_plane(PlaneDefinition::with_exact_coefficients(
        static_cast<std::uint32_t>(to_.exact_coefficients.size() - 1)));
  }
  how.a = point(PointId(how.a)).value();
  how.b = point(PointId(how.b)).value();
  if (how.kind() == Kind::three_points) {
    how.c = point(PointId(how.c)).value();
  } else if (how.kind() == Kind::along_direction) {
    how = PlaneDefinition::along_direction(PointId(how.a), PointId(how.b),
                                           direction(how.direction()));
  }
  if (turned) turn(how);
  return to_.add_plane(how);
}

PlaneId add_turned_plane(Geometry& geometry, PlaneId s) {
  using Kind = PlaneDefinition::Kind;
  PlaneDefinition how = geometry.definition(s);
  if (how.kind() == Kind::coefficients)
    return geometry.add_plane(negated(geometry.coefficients[how.a]));
  if (how.kind() == Kind::exact_coefficients) {
    geometry.exact_coefficients.push_back(negated(*geometry.exact_coefficients[how.a]));
    return geometry.add_plane(PlaneDefinition::with_exact_coefficients(
        static_cast<std::uint32_t>(geometry.exact_coefficients.size() - 1)));
  }
  turn(how);
  return geometry.add_plane(how);
}

void copy_with_room(const Geometry& from, const Geometry& more, Geometry& to) {
  const auto copy = [&](auto Geometry::*table) {
    (to.*table).reserve((from.*table).size() + (more.*table).size());
    to.*table = from.*table;
  };
  copy(&Geometry::positions);
  copy(&Geometry::construct);
  copy(&Geometry::constructions);
  copy(&Geometry::moved);
  copy(&Geometry::planes);
  copy(&Geometry::coefficients);
  copy(&Geometry::exact_coefficients);
  to.frames = from.frames;
  to.directions = from.directions;
}

GeometryOffset append_geometry(const Geometry& from, Geometry& to, bool turned) {
  using Kind = PlaneDefinition::Kind;
  const GeometryOffset offset{static_cast<std::uint32_t>(to.positions.size()),
                              static_cast<std::uint32_t>(to.planes.size())};
  const auto size = [](const auto& table) { return static_cast<std::uint32_t>(table.size()); };
  const std::uint32_t constructions = size(to.constructions), coefficients = size(to.coefficients),
                      exact = size(to.exact_coefficients), moved = size(to.moved);
  to.positions.append(from.positions);
  for (const PlaneCoefficients& k : from.coefficients)
    to.coefficients.push_back(turned ? negated(k) : k);
  for (const auto& k : from.exact_coefficients)
    to.exact_coefficients.push_back(turned ? negated(*k) : k);
  const auto make_room = [](auto& table, const auto& more) {
    if (table.empty()) table.reserve(more.size());
  };
  make_room(to.construct, from.construct);
  make_room(to.constructions, from.constructions);
  make_room(to.planes, from.planes);
  std::vector<std::uint32_t> frames, directions;
  for (const auto& f : from.frames) frames.push_back(to.frames.place(f));
  for (const auto& d : from.directions) directions.push_back(to.directions.place(d));
  for (const MovedPoint& p : from.moved) to.moved.push_back({p.local, frames[p.frame]});
  for (const std::uint32_t c : from.construct)
    to.construct.add(c == Geometry::explicit_point ? c
                     : c < Geometry::moved_point   ? c + constructions
                                                   : c + moved);
  for (const Construction& c : from.constructions)
    to.constructions.push_back({offset.plane(c.a), offset.plane(c.b), offset.plane(c.c),
                                offset.point(c.line_from), offset.point(c.line_to)});
  for (PlaneDefinition s : from.planes) {
    if (s.kind() == Kind::coefficients) {
      s.a += coefficients;
    } else if (s.kind() == Kind::exact_coefficients) {
      s.a += exact;
    } else {
      if (s.kind() == Kind::three_points)
        s.c += offset.points;
      else if (s.kind() == Kind::along_direction)
        s.c = PlaneDefinition::first_direction + directions[s.direction()];
      s.a += offset.points;
      s.b += offset.points;
      if (turned) turn(s);
    }
    to.planes.add(s);
  }
  return offset;
}

}  // namespace sectile
