#include "boolean/report/report_names.h"

namespace sectile {
namespace {

template <class Tag>
Id<Tag> in_operand(Id<Tag> id, const std::vector<Id<Tag>>& known, std::size_t loaded,
                   std::size_t in_solid) {
  if (id.value() < known.size()) return known[id.value()];
  return id.value() < loaded ? id : Id<Tag>(id.value() - loaded + in_solid);
}

}  // namespace

FaceId in_operand(const Patch& patch, FaceId f) {
  if (!patch.solid) return f;
  return in_operand(f, patch.face_in_solid, patch.loaded_faces, patch.solid->brep().face_count());
}

EdgeId in_operand(const Patch& patch, EdgeId e) {
  if (!patch.solid) return e;
  return in_operand(e, patch.edge_in_solid, patch.loaded_edges, patch.solid->brep().edge_count());
}

VertexId in_operand(const Patch& patch, VertexId v) {
  if (!patch.solid) return v;
  return in_operand(v, patch.vertex_in_solid, patch.loaded_vertices,
                    patch.solid->brep().vertex_count());
}

Entity in_operand(const Patch& patch, Entity entity) {
  switch (entity.kind()) {
    case Entity::Kind::vertex:
      return in_operand(patch, entity.vertex());
    case Entity::Kind::edge:
      return in_operand(patch, entity.edge());
    case Entity::Kind::face:
      return in_operand(patch, entity.face());
    case Entity::Kind::nothing:
      break;
  }
  return entity;
}

TraceEntity traced(const Patch& patch, Entity entity) {
  const Entity known = in_operand(patch, entity);
  // The kinds stand in one order.
  return {static_cast<TraceEntity::Kind>(known.kind()), known.index()};
}

}  // namespace sectile
