#include "boolean/components/point_in_face.h"

#include <vector>

#include "geometry/axes.h"
#include "geometry/probe.h"
#include "geometry/x_ray.h"

namespace sectile {
namespace {

// The way leads to no middle: where parts are alike, and in rows, a ray from a middle comes near
// edges of all others.
PointId point_beside_corner(Workspace& w, const Patch& patch, FaceId face, HalfEdgeId corner,
                            double part) {
  const Brep& brep = patch.brep;
  const auto at = [&](HalfEdgeId h, int axis) {
    return component(w.geometry.position(brep.point_of(brep.from(h))), axis);
  };
  const auto across = [&](int axis) {
    const double beyond =
        0.57 * at(brep.prev_of(corner), axis) + 0.43 * at(brep.next_of(corner), axis);
    return plane_across(w, axis, (1 - part) * at(corner, axis) + part * beyond);
  };
  const PlaneId plane = patch.plane(face);
  const int axis = w.tests().main_axis(plane);
  const Construction how{plane, across(next_axis(axis)), across(next_next_axis(axis)), {}, {}};
  const PointId made = add_constructed(w.geometry, how, w.tests().construct(how));
  w.kernel->refresh();
  return made;
}

// On a line through an edge: is it on the edge?
bool is_between(const Kernel& kernel, PointId from, PointId p, PointId to) {
  for (int axis = 0; axis < 3; ++axis)
    if (kernel.compare(from, p, axis) * kernel.compare(p, to, axis) == Sign::negative) return false;
  return true;
}

// Off all edges? Needs no planes through these (Patch::side_plane).
bool is_within(const Kernel& kernel, const Brep& brep, FaceId face, PointId p) {
  const int axis = kernel.main_axis(brep.plane[face]), next = next_axis(axis);
  XRayParity parity;
  bool is_on_edge = false;
  for_each_in_face(brep, face, [&](HalfEdgeId h) {
    const PointId u = brep.point_of(brep.from(h)), v = brep.point_of(brep.to(h));
    const Sign turn = kernel.turn(u, v, p, axis);
    is_on_edge |= turn == Sign::zero && is_between(kernel, u, p, v);
    parity.add(kernel.compare(p, u, next) == Sign::positive,
               kernel.compare(p, v, next) == Sign::positive, [&] { return turn; });
  });
  return !is_on_edge && parity.odd();
}

}  // namespace

PointId point_in_face(Workspace& w, const Patch& patch, FaceId face, double part,
                      const std::function<bool(PointId)>& take) {
  std::vector<HalfEdgeId> corners;
  for_each_in_loop(patch.brep, patch.brep.outer_loop[face],
                   [&](HalfEdgeId h) { corners.push_back(h); });
  for (const HalfEdgeId corner : corners) {
    const PointId made = point_beside_corner(w, patch, face, corner, part);
    if (is_within(w.tests(), patch.brep, face, made) && take(made)) return made;
  }
  return {};
}

PlaneId plane_across(Workspace& w, int axis, double at) {
  double normal[3] = {0, 0, 0};
  normal[axis] = 1;
  const PlaneId made =
      w.geometry.add_plane(PlaneCoefficients{normal[0], normal[1], normal[2], -at});
  w.kernel->refresh();
  return made;
}

}  // namespace sectile
