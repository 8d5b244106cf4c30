#include "boolean/face_location.h"

#include "boolean/crowded_corners.h"
#include "boolean/ray_count.h"

namespace sectile {
namespace {

// Is a point in the triangle on the inner side of an edge (positive), on its line, or beyond it?
Sign inner_side(const Kernel& kernel, const Patch& patch, HalfEdgeId h, const Probe& point) {
  const Brep& brep = patch.brep;
  const PointId from = brep.point_of(brep.from(h)), to = brep.point_of(brep.to(h));
  if (const auto turn = point.turn(brep.plane_of(h), from, to)) return *turn;
  const PlaneId plane = patch.side(h);
  const Sign sign = point.side(plane);
  if (sign == Sign::zero) return sign;
  return sign * kernel.side(brep.point_of(brep.from(brep.prev_of(h))), plane);
}

// Doubles tell the side of each edge, as a rule. Where they do not, the ends of the edges do, or
// the plane through the edge, with the triangle's third corner on its inner side.
Entity locate_in_triangle(const Kernel& kernel, const Patch& patch, HalfEdgeId first,
                          const Probe& point) {
  const Brep& brep = patch.brep;
  const PlaneId face = brep.plane_of(first);
  const int axis = kernel.main_axis(face);
  const Sign inner = kernel.normal(face, axis);
  Entity on;
  int touched = 0;
  HalfEdgeId h = first;
  for (int i = 0; i < 3; ++i, h = brep.next_of(h)) {
    const Sign turn =
        point.clear_turn(brep.point_of(brep.from(h)), brep.point_of(brep.to(h)), axis);
    if (turn == inner) continue;
    if (turn == -inner) return {};
    const Sign side = inner_side(kernel, patch, h, point);
    if (side == Sign::negative) return {};
    if (side == Sign::zero) {
      // On two of the three lines: on the corner between them.
      if (++touched == 1)
        on = Brep::edge_of(h);
      else if (i == 2 && on == Entity(Brep::edge_of(first)))
        on = brep.from(first);
      else
        on = brep.from(h);
    }
  }
  return touched > 0 ? on : Entity(brep.face_of(first));
}

}  // namespace

void locate(const Kernel& kernel, const Patch& patch, FaceId face, const Probe& point,
            std::vector<Entity>& found) {
  found.clear();
  if (patch.unbounded) {
    found.push_back(face);
    return;
  }
  const Brep& brep = patch.brep;
  const LoopId outer = brep.outer_loop[face];
  const HalfEdgeId first = brep.loop_half_edge[outer];
  if (!brep.next_loop[outer].valid() && brep.next_of(brep.next_of(brep.next_of(first))) == first) {
    const Entity on = locate_in_triangle(kernel, patch, first, point);
    if (!on.is_nothing()) found.push_back(on);
    return;
  }

  if (!patch.crowded.empty())
    if (const CrowdedCorners* crowded = patch.crowded_corners(face);
        crowded && crowded->touch(kernel, patch, patch.plane(face), point, found))
      return;
  RayCount count(kernel, patch, patch.plane(face), point, found);
  if (const Patch::Outline* outline = patch.outline(face)) {
    count.add(outline->tree, outline->half_edges);
  } else {
    for_each_in_face(brep, face, [&](HalfEdgeId h) { count.add(h); });
  }
  if (found.empty() && count.odd()) found.push_back(face);
}

}  // namespace sectile
