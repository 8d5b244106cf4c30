// Crowded lines that cross within a face, or of which one ends at an edge that is on another one.
//
// What runs along one of them leads away from the other one there; it is in a row, not in segments.
#pragma once

#include <span>

#include "boolean/reduction/on_line.h"

namespace sectile {

/// Adds to LineOfBoth::crossed of lines that are swept. `faces`: on both sides of lines, ascending.
/// Adds points to the workspace's geometry.
void add_crossings_of_lines(Workspace& w, std::span<const FaceOnLine> faces, LinesOfBoth& lines);

}  // namespace sectile
