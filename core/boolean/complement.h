// A solid that is taken away from another one.
//
// Where a solid touches itself in a line, each of its edges there belongs to one wedge of material.
// Turned inside out, the same faces bound the wedges between: they have to be paired anew, also
// where the other solid is not near.
#pragma once

#include "storage/solid_data.h"

namespace sectile {

/// The same boundary, so that it bounds wedges of material when it is turned inside out.
const SolidData& reversible(const SolidData& solid);

}  // namespace sectile
