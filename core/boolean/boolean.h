// The outline that Booleans, splitting, classification and complements share.
#pragma once

#include "boolean/components/components.h"
#include "boolean/joining/joining.h"

namespace sectile {

/// What is loaded of a boundary: events name entities of one block.
inline const SolidData& as_observed(const SolidData& solid, const BooleanOptions& options) {
  return options.observer ? solid.in_one_block() : solid;
}
inline const SolidData& operand(const Solid& solid, const BooleanOptions& options) {
  return as_observed(*solid.data(), options);
}
inline BooleanOptions without_observer(BooleanOptions options) {
  options.observer = nullptr;
  return options;
}
/// What boolean() does with two solids of which neither is empty, even if they are the same.
Solid boolean_by_cutting(const Solid& a, const Solid& b, Operation operation,
                         const BooleanOptions& options);

/// Both boundaries, cut for all wanted operations, with what the phases found.
struct CutBoundaries {
  Contacts contacts;
  Neighborhoods neighborhoods;
  JoinedCuts joined;
};

/// Phases 1 to 4. The patches of the workspace are cut.
CutBoundaries cut(Workspace& w, const FacePairs& pairs, const Wanted& wanted);
/// The same, where the contacts are known.
CutBoundaries cut_at(Workspace& w, Contacts contacts, const Wanted& wanted);

/// Phases 5 to 7 for the wanted operation of that number.
Solid assemble(Workspace& w, const CutBoundaries& boundaries, Operation operation,
               std::size_t number);
/// The same, where it is known which faces stay.
Solid assemble(Workspace& w, const CutBoundaries& boundaries, const FaceLabels& kept,
               Operation operation, std::size_t number);

}  // namespace sectile
