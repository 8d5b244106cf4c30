// What lies around each contact segment: the half-planes of both solids, sorted around the line.
//
// This one sort decides all that the paper settles case by case in 6.1 and 6.2 (Tables II and III,
// figures 17 to 20): see docs/paper.md.
#pragma once

#include <span>

#include "boolean/workspace.h"

namespace sectile {

/// Groups the records into segments, sorts and classifies their half-planes, and finds for each
/// wanted operation the wedges of material, and which carriers they cut. If no operation is wanted,
/// the carriers between whose sides the class changes are cut (the eight-way classification).
void find_neighborhoods(Workspace& w, std::span<const Operation> wanted);

}  // namespace sectile
