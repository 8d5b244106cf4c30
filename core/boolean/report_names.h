// How the report names entities: with the numbers that they have in the operand. What the operation
// made is counted on from there.
#pragma once

#include <string>

#include "boolean/workspace.h"

namespace sectile {

FaceId in_operand(const Patch& patch, FaceId f);
EdgeId in_operand(const Patch& patch, EdgeId e);
VertexId in_operand(const Patch& patch, VertexId v);
Entity in_operand(const Patch& patch, Entity entity);

/// As it prints: v12, e3, f7.
std::string name_of(const Patch& patch, Entity entity);

}  // namespace sectile
