#include "storage/compact_triangles.h"

namespace sectile {

Brep make_brep(const CompactTriangles& of) {
  Brep brep;
  brep.resize_half_edges(of.half_edge_count);
  brep.vertex_half_edge.reserve(of.positions.size());
  brep.point.reserve(of.positions.size());
  brep.reserve_faces(of.triangles.size());
  const auto is_border = [&](HalfEdgeId h) { return h.value() < 2 * of.border.size(); };
  for (const auto& [vertex, half_edge, source] : of.triangles) {
    const LoopId loop(brep.loop_count());
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdgeId h(half_edge[k]);
      brep.next[h] = HalfEdgeId(half_edge[(k + 1) % 3]);
      brep.prev[h] = HalfEdgeId(half_edge[(k + 2) % 3]);
      brep.loop[h] = loop;
      brep.origin[h] = VertexId(vertex[k]);
      if (is_border(h)) brep.origin[Brep::twin(h)] = VertexId(vertex[(k + 1) % 3]);
      if (vertex[k] < brep.point.size()) continue;
      brep.point.add(PointId(vertex[k]));
      brep.vertex_half_edge.add(h);
    }
    const PlaneId plane(loop.value());
    brep.add_loop(brep.add_face(plane, {of.origin, source}, loop), HalfEdgeId(half_edge[0]));
  }
  return brep;
}

Geometry make_geometry(const CompactTriangles& of) {
  Geometry geometry;
  geometry.positions.reserve(of.positions.size());
  geometry.construct.reserve(of.positions.size());
  for (const Vec3& p : of.positions) geometry.add_point(p);
  geometry.planes.reserve(of.triangles.size());
  for (const auto& triangle : of.triangles) {
    const auto& [a, b, c] = triangle.vertex;
    geometry.add_plane(PlaneDefinition::through(PointId(a), PointId(b), PointId(c)));
  }
  return geometry;
}

}  // namespace sectile
