// A solid that is taken away from another one.
//
// Where a solid touches itself in a line, each of its edges there belongs to one wedge of material.
// Turned inside out, the same faces bound the wedges between: they have to be paired anew, also
// where the other solid is not near. That takes the blocks around such lines only: those that start
// at vertices where the structure says so (topology/touching_vertices.h), and on from there. Where
// none starts (storage/touching_lines.h), as where solids touch in single vertices, nothing is
// done. Along other lines, as where an edge lies within a face, the pairs stay as they are: they
// bound the same solid. What runs along one line, in whatever order it begins and ends, is one row
// (neighborhoods/row_sweep.h): where a wedge ends, those beside it are divided, and no others.
#pragma once

#include "storage/solid_data.h"

namespace sectile {

/// The same boundary, so that it bounds wedges of material when it is turned inside out.
const SolidData& reversible(const SolidData& solid);

}  // namespace sectile
