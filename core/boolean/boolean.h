// The outline that Booleans, splitting, classification and complements share.
#pragma once

#include "boolean/joining/joining.h"

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

/// Both boundaries, cut for all wanted operations, with what the phases found.
struct CutBoundaries {
  Contacts contacts;
  Neighborhoods neighborhoods;
  JoinedCuts joined;
};

/// Phases 1 to 4. The patches of the workspace are cut.
CutBoundaries cut(Workspace& w, const FacePairs& pairs, const Wanted& wanted);

/// Phases 5 to 7 for the wanted operation of that number.
Solid assemble(Workspace& w, const CutBoundaries& boundaries, Operation operation,
               std::size_t number);

}  // namespace sectile
