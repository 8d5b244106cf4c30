#include "boolean/line.h"

namespace sectile {

std::pair<PlaneId, PlaneId> line_planes(const Patch& patch, HalfEdgeId h) {
  // The same two for both half-edges, so that points know each other by them.
  HalfEdgeId first = Brep::half_edge(Brep::edge_of(h));
  if (!patch.is_real(patch.brep.face_of(first))) first = Brep::twin(first);
  return {patch.plane(patch.brep.face_of(first)), patch.side(first)};
}

Construction edge_plane_construction(const Workspace& w, Operand operand, HalfEdgeId h,
                                     PlaneId plane) {
  const Brep& brep = w.patch[operand].brep;
  const Geometry& g = w.geometry;
  const auto [a, b] = line_planes(w.patch[operand], h);
  Construction how{a, b, plane, PointId(), PointId()};
  const PointId ends[2] = {brep.point_of(brep.from(h)), brep.point_of(brep.to(h))};
  if (!g.is_constructed(ends[0]) && !g.is_constructed(ends[1])) {
    how.line_from = ends[0];
    how.line_to = ends[1];
    return how;
  }
  // A piece of an input edge: an end that was made by cutting it still knows the whole.
  for (const PointId p : ends) {
    if (!g.is_constructed(p)) continue;
    const Construction& known = g.construction(p);
    if (!known.line_from.valid()) continue;
    if ((known.a == a && known.b == b) || (known.a == b && known.b == a)) {
      how.line_from = known.line_from;
      how.line_to = known.line_to;
    }
  }
  return how;
}

}  // namespace sectile
