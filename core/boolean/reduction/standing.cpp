#include "boolean/reduction/standing.h"

#include "sectile/errors.h"

namespace sectile {

const CrowdedCorners::Fan* crowded_fan(const Patch& patch, FaceId face, VertexId v) {
  if (patch.crowded.empty()) return nullptr;
  const CrowdedCorners* const crowded = patch.crowded_corners(face);
  return crowded ? crowded->at(v) : nullptr;
}

bool is_of(const Patch& patch, FaceId face, const BoundaryItem& item, VertexId v) {
  if (item.entity == Entity(v) || item.h.valid()) return item.entity == Entity(v);
  const CrowdedCorners::Fan* const fan = crowded_fan(patch, face, v);
  return fan && fan->vertices[0] == item.entity.vertex();
}

void add_items(const Patch& patch, FaceId face, Entity entity, std::vector<BoundaryItem>& items) {
  const Brep& brep = patch.brep;
  const CrowdedCorners::Fan* const fan =
      entity.is_vertex() ? crowded_fan(patch, face, entity.vertex()) : nullptr;
  if (fan) {
    items.push_back({fan->vertices[0], HalfEdgeId()});
  } else if (entity.is_edge()) {
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
Standing among(const Kernel& kernel, const Patch& patch, FaceId face,
               std::span<const BoundaryItem> items, Direction d) {
  const PlaneId plane = patch.plane(face);
  struct Bound {
    Direction direction;
    bool leaves;
    HalfEdgeId h;
    Entity entity;
  };
  std::vector<Bound> bounds;
  for (const BoundaryItem& item : items) {
    if (!item.h.valid()) {
      const auto& last = crowded_fan(patch, face, item.entity.vertex())->corners.last(kernel, d);
      bounds.push_back({last.direction, last.begins, last.h,
                        last.begins ? patch.brep.from(last.h) : patch.brep.to(last.h)});
      continue;
    }
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
  if (items.size() > 1 || !items[0].h.valid()) return among(kernel, patch, face, items, d);
  return items[0].entity.is_edge() ? on_edge(kernel, patch, items[0], d)
                                   : at_corner(kernel, patch, items[0], d);
}

Entity end_along(const Patch& patch, HalfEdgeId h, std::span<const BoundaryItem> items) {
  const Entity edge = Brep::edge_of(h);
  const VertexId from = patch.brep.from(h), to = patch.brep.to(h);
  for (const BoundaryItem& item : items) {
    if (item.entity == edge) return edge;
    for (const VertexId v : {from, to})
      if (is_of(patch, patch.brep.face_of(h), item, v)) return v;
  }
  throw InternalError("a segment along an edge ends away from it");
}

}  // namespace sectile
