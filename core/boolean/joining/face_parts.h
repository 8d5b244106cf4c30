// After joining, a face's loops bound its parts: which loops are outer ones, and to which part each
// inner loop belongs.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Gives each part of each divided face its own face, with its outer loop first. `divided`: per
/// loaded face.
void settle_face_parts(Workspace& w, const PerOperand<Table<FaceId, std::uint8_t>>& divided);

}  // namespace sectile
