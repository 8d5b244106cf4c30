// How a direction stands to a face at a point of its closure.
#pragma once

#include <span>
#include <vector>

#include "boolean/crowded_corners.h"
#include "boolean/direction.h"
#include "boolean/entity.h"
#include "boolean/workspace.h"

namespace sectile {

/// Something of a face's boundary at a place: a corner (the half-edge that leaves it) or a
/// half-edge that passes through. Where very many corners of the face are in one point: all of
/// them, with the vertex that stands for them, and no half-edge.
struct BoundaryItem {
  Entity entity;
  HalfEdgeId h;
  friend auto operator<=>(const BoundaryItem&, const BoundaryItem&) = default;
};

/// The very many corners of a face in the point of a vertex; null if there are not that many.
const CrowdedCorners::Fan* crowded_fan(const Patch& patch, FaceId face, VertexId v);
/// Does the item say what a vertex, of the face as well, is there?
bool is_of(const Patch& patch, FaceId face, const BoundaryItem& item, VertexId v);

struct Standing {
  enum class Where : std::uint8_t { outside, inside, along } where = Where::outside;
  Entity entity;         ///< what the direction leaves from: face, edge or vertex
  HalfEdgeId half_edge;  ///< along: the half-edge of the face
};

/// Adds what the entity has of the face's boundary: corners of a vertex, the face's half-edge of an
/// edge, nothing for the face itself.
void add_items(const Patch& patch, FaceId face, Entity entity, std::vector<BoundaryItem>& items);

/// The direction d of the face's plane, at a place where the face's boundary has these items (none:
/// the place is inside the face).
Standing standing(const Kernel& kernel, const Patch& patch, FaceId face,
                  std::span<const BoundaryItem> items, Direction d);

/// For a segment along a half-edge: what of these items is the edge or its end. Several edges of a
/// face that touches itself may run there.
Entity end_along(const Patch& patch, HalfEdgeId h, std::span<const BoundaryItem> items);

}  // namespace sectile
