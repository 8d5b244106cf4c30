// The parts of the report that show the geometry: sectors around a place, half-planes around a
// segment. In doubles, for drawing.
#pragma once

#include <vector>

#include "boolean/neighborhoods/neighborhoods.h"
#include "sectile/trace.h"

namespace sectile {

Vec3 unit(const Vec3& v);
Vec3 between(const Vec3& from, const Vec3& to);
/// The outward normal of a plane.
Vec3 unit_normal(const Geometry& geometry, PlaneId plane);
/// The direction in which a segment runs.
Vec3 unit_direction(const Workspace& w, const Contacts& contacts, const Segment& segment);

TracePlace place_at(const Workspace& w, const Contacts& contacts, PlaceId place);

/// Adds what the faces of an operand have around an entity of it: a cycle of sectors.
void add_sectors(const Workspace& w, Operand operand, Entity entity,
                 std::vector<TraceSector>& sectors);

/// The half-planes of a segment, with what becomes of them.
std::vector<TraceHalfPlane> trace_half_planes(const Workspace& w, const Contacts& contacts,
                                              const Neighborhoods& neighborhoods,
                                              const Segment& segment, Operation operation);

}  // namespace sectile
