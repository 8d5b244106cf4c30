#include "boolean/patch_euler.h"

namespace sectile {

HalfEdgeId PatchEuler::grown(HalfEdgeId made, FaceId root, PlaneId side) {
  while (patch_.root.size() < patch_.brep.face_count()) patch_.root.add(root);
  return grown(made, side, side);
}

HalfEdgeId PatchEuler::divide(HalfEdgeId h, PointId point) {
  const VertexId vertex = euler_.semv(h, point);
  return grown(patch_.brep.vertex_half_edge[vertex], patch_.side(h), patch_.side(Brep::twin(h)));
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
