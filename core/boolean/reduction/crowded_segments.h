// Lines along which very many edges run, of which each meets but few faces or edges of the other
// operand: a book that stands on a floor, or leans on an edge.
//
// All pairs are few, but each edge would be divided at the ends of all others.
#pragma once

#include "boolean/reduction/reduction.h"

namespace sectile {

/// Adds the lines to the workspace, and marks the vertices on them in its patches.
void mark_crowded_segments(Workspace& w, const Contacts& found);

}  // namespace sectile
