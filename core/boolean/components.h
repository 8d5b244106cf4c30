// Phase 6: the cut surfaces fall apart; which pieces stay in the result.
#pragma once

#include <functional>

#include "boolean/rest_labels.h"
#include "boolean/workspace.h"

namespace sectile {

/// Per solid: a label for each face, 0 for those that are of no interest. Loaded faces that were
/// cut fall into parts, each with a label of its own.
struct FaceLabels {
  std::vector<std::uint8_t> loaded[2];  ///< per face of the patch
  RestLabels rest[2];                   ///< what is not loaded
};

/// Labels spread from the contact segments; all that reach one piece must agree. A shell that
/// touches nothing takes one exact ray. The label is what `label_of` says of a solid's class.
using LabelOf = std::function<std::uint8_t(int solid, Class)>;
FaceLabels find_components(Workspace& w, const LabelOf& label_of);

/// Label 1: the faces that are in the boundary of a result.
FaceLabels find_kept(Workspace& w, Operation operation);

}  // namespace sectile
