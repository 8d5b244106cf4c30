// The steps that Booleans, splitting and classification share.
#pragma once

#include <span>

#include "boolean/reduction/reduction.h"

namespace sectile {

/// What is loaded of a solid: events name entities of one block.
inline const SolidData& operand(const Solid& solid, const BooleanOptions& options) {
  return options.observer ? solid.data()->in_one_block() : *solid.data();
}
inline BooleanOptions without_observer(BooleanOptions options) {
  options.observer = nullptr;
  return options;
}
/// Loads the faces that may meet; `pairs` are pairs of loaded faces, ascending.
void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs);
/// The loaded face that stands for a face of the operand.
FaceId loaded_face(const Patch& patch, FaceId face);
/// Phases 1 to 5: both boundaries are cut for all wanted operations.
void cut(Workspace& w, const FacePairs& pairs, std::span<const Operation> wanted);
/// Phases 6 to 8 for one of the wanted operations.
Solid assemble(Workspace& w, Operation operation, std::size_t index);

}  // namespace sectile
