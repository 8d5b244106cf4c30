// Phase 5: the cut surfaces fall apart; which pieces stay in the result.
#pragma once

#include <functional>

#include "boolean/components/rest_labels.h"
#include "boolean/joining/joining.h"

namespace sectile {

/// A label for each face, 0 for those that are of no interest. Loaded faces that were cut fall into
/// parts, each with a label of its own.
struct FaceLabels {
  PerOperand<Table<FaceId, std::uint8_t>> loaded;  ///< of the patch
  PerOperand<RestLabels> rest;                     ///< what is not loaded
};

/// Labels spread from the contact segments; all that reach one piece must agree. A shell that
/// touches nothing takes one exact ray. The label is what `label_of` says of an operand's class.
/// May add points and planes to the workspace's geometry.
using LabelOf = std::function<std::uint8_t(Operand, Class)>;
FaceLabels find_components(Workspace& w, const Contacts& contacts,
                           const Neighborhoods& neighborhoods, const JoinedCuts& joined,
                           const LabelOf& label_of);

/// Label 1: the faces that are in the boundary of a result.
FaceLabels find_kept(Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                     const JoinedCuts& joined, Operation operation);

}  // namespace sectile
