// Does a boundary that touches itself do so in lines, or in single places only?
#pragma once

#include "storage/solid_data.h"

namespace sectile {

/// May two edges, or an edge and a face, lead along each other from a place at which several
/// vertices are, or from which several edges lead to one place? False only if doubles tell that
/// none do.
bool may_touch_in_lines(const SolidData& solid);

}  // namespace sectile
