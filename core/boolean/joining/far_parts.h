// Which far loops belong to which part of their face.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// After the parts of the divided faces have their own faces. `divided`: per loaded face.
void settle_far_loops(Workspace& w, const PerOperand<Table<FaceId, std::uint8_t>>& divided);

}  // namespace sectile
