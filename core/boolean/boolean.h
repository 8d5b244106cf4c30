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
/// Loads the faces that may meet; `pairs` are pairs of loaded faces, ascending.
/// What `wanted` says will be made of them, and nothing else.
void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs,
          const Wanted& wanted = {});
/// Both operands are one solid, of which nothing but the faces in some of its slots can be loaded.
void load_slots(Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots,
                FacePairs& pairs);
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
/// The same, where the contacts are known.
CutBoundaries cut_at(Workspace& w, Contacts contacts, const Wanted& wanted);

/// Phases 5 to 7 for the wanted operation of that number.
Solid assemble(Workspace& w, const CutBoundaries& boundaries, Operation operation,
               std::size_t number);
/// The same, where it is known which faces stay.
Solid assemble(Workspace& w, const CutBoundaries& boundaries, const FaceLabels& kept,
               Operation operation, std::size_t number);

}  // namespace sectile
