// Where segments meet what runs along lines: those that lead away from it, and those that cross it
// within a face.
#pragma once

#include <span>

#include "boolean/reduction/on_line.h"

namespace sectile {

/// Fills in OnLine::met and LineOfBoth::crossed of lines that are swept. What is on these is in no
/// segment any more. `faces`: on both sides of lines, ascending. Adds points to the workspace's
/// geometry.
void add_met_places(Workspace& w, const Contacts& found, std::span<const FaceOnLine> faces,
                    LinesOfBoth& lines);

}  // namespace sectile
