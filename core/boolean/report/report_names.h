// How the report names entities, with the numbers that they have in the operand. What the operation
// made is counted on from there.
#pragma once

#include "boolean/entity.h"
#include "boolean/workspace.h"
#include "sectile/trace.h"

namespace sectile {

FaceId in_operand(const Patch& patch, FaceId f);
EdgeId in_operand(const Patch& patch, EdgeId e);
VertexId in_operand(const Patch& patch, VertexId v);
Entity in_operand(const Patch& patch, Entity entity);

/// The same for those who look on. The entity is not nothing.
TraceEntity traced(const Patch& patch, Entity entity);
/// 0: A, 1: B.
constexpr std::uint8_t number_of(Operand operand) {
  return static_cast<std::uint8_t>(operand);
}

}  // namespace sectile
