// After joining, a face's loops bound its parts: which loops are outer ones, and to which part each
// inner loop belongs.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Gives each part of each cut face its own face, with its outer loop first.
void settle_face_parts(Workspace& w);

/// Is a loop of a plane counter-clockwise, seen against the plane's normal? Neighbouring points
/// differ in place. Loops that touch themselves are allowed.
bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop);

}  // namespace sectile
