#include "boolean/reduction/standing.h"

#include "sectile/errors.h"

namespace sectile {

void add_items(const Patch& patch, FaceId face, Entity entity, std::vector<BoundaryItem>& items) {
  const Brep& brep = patch.brep;
  if (entity.is_edge()) {
    for (unsigned side = 0; side < 2; ++side) {
      const HalfEdgeId h = Brep::half_edge(entity.edge(), side);
      if (brep.face_of(h) == face) items.push_back({entity, h});
    }
  } else if (entity.is_vertex() && !patch.outline(face)) {
    // A face without a tree has few corners, but a vertex may have thousands of sectors.
    for_each_in_face(brep, face, [&](HalfEdgeId h) {
      if (brep.from(h) == entity.vertex()) items.push_back({entity, h});
    });
  } else if (entity.is_vertex()) {
    for_each_around(brep, brep.vertex_half_edge[entity.vertex()], [&](HalfEdgeId h) {
      if (brep.face_of(h) == face) items.push_back({entity, h});
    });
  }
}

namespace {

using Where = Standing::Where;

Standing at_corner(const Kernel& kernel, const Patch& patch, const BoundaryItem& item,
                   Direction d) {
  switch (within_corner(kernel, patch, item.h, d)) {
    case Within::outside:
      return {Where::outside, item.entity, {}};
    case Within::inside:
      return {Where::inside, item.entity, {}};
    case Within::along_first:
      return {Where::along, item.entity, item.h};
    case Within::along_last:
      break;
  }
  return {Where::along, item.entity, patch.brep.prev_of(item.h)};
}

Standing on_edge(const Kernel& kernel, const Patch& patch, const BoundaryItem& item, Direction d) {
  switch (turn_from(kernel, patch.brep.point_of(patch.brep.to(item.h)), d)) {
    case Sign::positive:
      return {Where::inside, item.entity, {}};
    case Sign::negative:
      return {Where::outside, item.entity, {}};
    case Sign::zero:
      break;
  }
  return {Where::along, item.entity, item.h};
}

// With several items, the one next to d clockwise decides: the face lies counter-clockwise of a
// half-edge that leaves. In a slit, one half-edge arrives where another one leaves: the face ends
// there and begins again.
Standing among(const Kernel& kernel, const Patch& patch, PlaneId plane,
               std::span<const BoundaryItem> items, Direction d) {
  struct Bound {
    Direction direction;
    bool leaves;
    HalfEdgeId h;
    Entity entity;
  };
  std::vector<Bound> bounds;
  for (const BoundaryItem& item : items) {
    const Direction out = direction_of(kernel, patch, item.h);
    bounds.push_back({out, true, item.h, item.entity});
    if (item.entity.is_edge()) {
      bounds.push_back({-out, false, item.h, item.entity});
    } else {
      const HalfEdgeId before = patch.brep.prev_of(item.h);
      bounds.push_back({-direction_of(kernel, patch, before), false, before, item.entity});
    }
  }
  const Bound* last = nullptr;
  for (const Bound& b : bounds) {
    if (turn(kernel, plane, d, b.direction) == Sign::zero &&
        same_way(kernel, plane, d, b.direction))
      return {Where::along, b.entity, b.h};
    if (!last || before_counter_clockwise(kernel, plane, d, last->direction, b.direction) ||
        (b.leaves && !before_counter_clockwise(kernel, plane, d, b.direction, last->direction)))
      last = &b;
  }
  return {last->leaves ? Where::inside : Where::outside, last->entity, {}};
}

}  // namespace

Standing standing(const Kernel& kernel, const Patch& patch, FaceId face,
                  std::span<const BoundaryItem> items, Direction d) {
  if (items.empty()) return {Where::inside, face, {}};
  if (items.size() > 1) return among(kernel, patch, patch.plane(face), items, d);
  return items[0].entity.is_edge() ? on_edge(kernel, patch, items[0], d)
                                   : at_corner(kernel, patch, items[0], d);
}

Entity end_along(const Brep& brep, HalfEdgeId h, std::span<const BoundaryItem> items) {
  const Entity edge = Brep::edge_of(h), from = brep.from(h), to = brep.to(h);
  for (const BoundaryItem& item : items)
    if (item.entity == edge || item.entity == from || item.entity == to) return item.entity;
  throw InternalError("a segment along an edge ends away from it");
}

}  // namespace sectile
