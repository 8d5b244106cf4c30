#include "boolean/patch_euler.h"

namespace sectile {

void PatchEuler::grow() {
  while (patch_.flat.size() < patch_.brep.edge_count()) {
    patch_.flat.add(0);
    for (int side = 0; side < 2; ++side) {
      patch_.side_plane.add({});
      patch_.half_edge_in_solid.add({});
    }
  }
}

HalfEdgeId PatchEuler::grown(HalfEdgeId made, FaceId root, PlaneId side) {
  grown(made);
  while (patch_.root.size() < patch_.brep.face_count()) patch_.root.add(root);
  patch_.side_plane[made] = patch_.side_plane[Brep::twin(made)] = side;
  return made;
}

HalfEdgeId PatchEuler::divide(HalfEdgeId h, PointId point) {
  const VertexId vertex = euler_.semv(h, point);
  const HalfEdgeId on = grown(patch_.brep.vertex_half_edge[vertex]);
  patch_.side_plane[on] = patch_.side(h);
  patch_.side_plane[Brep::twin(on)] = patch_.side(Brep::twin(h));
  patch_.flat[Brep::edge_of(on)] = patch_.flat[Brep::edge_of(h)];
  return on;
}

HalfEdgeId PatchEuler::mef(HalfEdgeId a, HalfEdgeId b, Euler::NewFace which, PlaneId side) {
  const FaceId root = patch_.root_of(b);
  return grown(euler_.mef(a, b, which), root, side);
}

HalfEdgeId PatchEuler::connect(HalfEdgeId a, HalfEdgeId b, PlaneId side) {
  const FaceId root = patch_.root_of(b);
  return grown(euler_.connect(a, b), root, side);
}

}  // namespace sectile
