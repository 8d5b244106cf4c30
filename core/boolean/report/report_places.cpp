#include "boolean/report/report_places.h"

#include <cmath>

#include "boolean/report/report_names.h"
#include "search/approximate.h"

namespace sectile {

Vec3 unit(const Vec3& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return length > 0 ? Vec3{v.x / length, v.y / length, v.z / length} : Vec3{};
}

Vec3 between(const Vec3& from, const Vec3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

Vec3 unit_normal(const Geometry& geometry, PlaneId plane) {
  const PlaneValue value = plane_value(geometry, plane);
  return unit({value.n[0], value.n[1], value.n[2]});
}

namespace {

Vec3 opposite(const Vec3& v) {
  return {-v.x, -v.y, -v.z};
}

// Of a solid that has all its faces: the operand, or the boundary of a half-space.
class SectorCollector {
 public:
  SectorCollector(const Workspace& w, Operand s, std::vector<TraceSector>& sectors)
      : patch_(w.patch[s]),
        brep_(patch_.solid ? patch_.solid->brep() : patch_.brep),
        geometry_(patch_.solid ? patch_.solid->geometry() : w.geometry),
        solid_(number_of(s)),
        sectors_(sectors) {}

  void add(Entity entity) {
    if (entity.is_vertex()) add_corners(entity.vertex());
    if (entity.is_edge()) add_sides(entity.edge());
    if (entity.is_face()) add_face(entity.face());
  }

 private:
  Vec3 direction(HalfEdgeId h) const {
    return unit(between(geometry_.position(brep_.point_of(brep_.from(h))),
                        geometry_.position(brep_.point_of(brep_.to(h)))));
  }

  TraceSector in_face(FaceId f) const {
    TraceSector sector;
    sector.solid = solid_;
    sector.face = f.value();
    sector.normal = unit_normal(geometry_, brep_.plane[f]);
    return sector;
  }

  void add_corners(VertexId v) {
    for_each_around(brep_, brep_.vertex_half_edge[v], [&](HalfEdgeId h) {
      const HalfEdgeId last = brep_.around(h);
      TraceSector sector = in_face(brep_.face_of(h));
      sector.from_edge = Brep::edge_of(h).value();
      sector.to_edge = Brep::edge_of(last).value();
      sector.from = direction(h);
      sector.to = direction(last);
      sectors_.push_back(sector);
    });
  }

  void add_sides(EdgeId e) {
    for (const unsigned side : {0u, 1u}) {
      const HalfEdgeId h = Brep::half_edge(e, side);
      TraceSector sector = in_face(brep_.face_of(h));
      sector.from_edge = sector.to_edge = e.value();
      sector.from = direction(h);
      sector.to = opposite(sector.from);
      sectors_.push_back(sector);
    }
  }

  void add_face(FaceId f) { sectors_.push_back(in_face(f)); }

  const Patch& patch_;
  const Brep& brep_;
  const Geometry& geometry_;
  std::uint8_t solid_;
  std::vector<TraceSector>& sectors_;
};

TraceClass traced_class(Class c) {
  switch (c) {
    case Class::in:
      return TraceClass::in;
    case Class::out:
      return TraceClass::out;
    case Class::on_plus:
      return TraceClass::on_plus;
    case Class::on_minus:
      break;
  }
  return TraceClass::on_minus;
}

bool is_on(const HalfPlane& h) {
  return h.cls == Class::on_plus || h.cls == Class::on_minus;
}

// Coplanar half-planes are neighbours in the order around the segment.
int coplanar_with(std::span<const HalfPlane> planes, std::size_t i) {
  if (!is_on(planes[i])) return -1;
  const std::size_t count = planes.size();
  for (const std::size_t j : {(i + 1) % count, (i + count - 1) % count}) {
    const HalfPlane& other = planes[j];
    const bool agree = (other.forward == planes[i].forward) == (other.cls == Class::on_plus);
    if (other.operand != planes[i].operand && other.cls == planes[i].cls && agree)
      return static_cast<int>(j);
  }
  return -1;
}

}  // namespace

TracePlace place_at(const Workspace& w, const Contacts& contacts, PlaceId place) {
  return {place.value(), w.geometry.position(contacts.point(place))};
}

void add_sectors(const Workspace& w, Operand operand, Entity entity,
                 std::vector<TraceSector>& sectors) {
  SectorCollector(w, operand, sectors).add(in_operand(w.patch[operand], entity));
}

Vec3 unit_direction(const Workspace& w, const Contacts& contacts, const Segment& segment) {
  const Vec3 along = between(w.geometry.position(contacts.point(segment.place[0])),
                             w.geometry.position(contacts.point(segment.place[1])));
  if (along != Vec3{}) return unit(along);
  // Ends that are one after rounding.
  if (!segment.plane[1].valid()) return {};
  return unit(approximate::cross(unit_normal(w.geometry, segment.plane[0]),
                                 unit_normal(w.geometry, segment.plane[1])));
}

std::vector<TraceHalfPlane> trace_half_planes(const Workspace& w, const Contacts& contacts,
                                              const Neighborhoods& neighborhoods,
                                              const Segment& segment, Operation operation) {
  const Vec3 along = unit_direction(w, contacts, segment);
  const std::span<const HalfPlane> planes = neighborhoods.half_planes[segment.half_planes];
  std::vector<TraceHalfPlane> found;
  found.reserve(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const HalfPlane& h = planes[i];
    const Carrier& carrier = neighborhoods.carriers[h.carrier];
    TraceHalfPlane t;
    t.solid = number_of(h.operand);
    t.forward = h.forward;
    t.face = in_operand(w.patch[h.operand], h.face).value();
    t.carrier = traced(w.patch[h.operand], carrier.entity);
    t.normal = unit_normal(w.geometry, h.plane);
    t.direction = unit(approximate::cross(t.normal, h.forward ? along : opposite(along)));
    t.before = traced_class(h.cls);
    t.after = traced_class(reclassified(operation, h.operand, h.cls));
    t.coplanar = coplanar_with(planes, i);
    t.kept = kept(operation, h.operand, h.cls);
    t.cut = carrier.cut;
    found.push_back(t);
  }
  return found;
}

}  // namespace sectile
